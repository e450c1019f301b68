# One point of a surface in a light.

lighting = Lighting
lighting-about = The light, the eye and the normal say how bright a point is: three terms, and each is one number.

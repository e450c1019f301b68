# Homogeneous rasterization

homogeneous = Homogeneous
homogeneous-about = Edge functions from x, y and w: no division, no clipping, right behind the eye.

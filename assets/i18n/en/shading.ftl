# The vertex and the fragment stage, and where light is computed.

shading = Shading
shading-about = Light once for a face, at its vertices, or at each pixel: what goes into the two stages, and what comes out.

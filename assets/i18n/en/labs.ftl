# Stages, and what keeps a lab from running

stage-scene = Scene
stage-model = Model
stage-view = View
stage-clip-space = Clip space
stage-cull = Cull
stage-clip = Clip
stage-divide = Divide
stage-viewport = Viewport
stage-scan-conversion = Scan
stage-fragments = Fragments
stage-stencil = Stencil
stage-depth = Depth
stage-blend = Blend
stage-image = Image

error-no-lab = The scene names no lab: choose one, or add a "lab" to the scene file.
error-window = The window is not one: each minimum must be at most its maximum.
error-polygon-corners = The window must have 3 to 32 corners.
error-polygon-not-finite = The window's corners must be finite numbers.
error-polygon-no-area = All corners lie on one line, so the window has no inside. Move one of them off the line.
error-polygon-not-convex = The window must be convex. Move the corner that bends inward, or undo.
error-nothing-to-step = Nothing to step: the scene gives the lab { $lab } no triangle. Add one, or choose a preset.
error-behind-the-eye = A corner of the square lies behind the eye, where nothing has an image. Move it to z below 0.
error-steps-one-sample = Stepping the whole scene shows one sample a pixel, and this scene has more. The lab Multisampling steps through samples.
error-mixed-depth-states = The scene's draws have different depth states, so they cannot be stepped as one z-buffer. Give all draws the same "depth".
error-no-layers = No layer comes to the pixel. Add one, or choose a preset.
error-too-large-to-step = This scene is too large to step as a whole (more than { $most } × { $most } pixels). Choose a lab; what happened to a pixel, the window tells at a click on it.

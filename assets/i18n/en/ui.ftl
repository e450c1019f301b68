# The window: menus, panels, timeline, keys

ui-menu-file = File
ui-menu-edit = Edit
ui-menu-view = View
ui-menu-help = Help
ui-menu-theme = Theme
ui-menu-choices = Choices
ui-file-open = Open…
ui-file-presets = Presets
ui-file-save = Save
ui-file-save-as = Save as…
ui-file-reset = Reset: take all edits back
ui-file-picture = Export picture…
ui-file-film = Export run as animated picture…
ui-file-quit = Quit
ui-copy-picture = Copy picture
ui-copy-values = Copy values as CSV
ui-edited = { $name }, edited
ui-edit-undo = Undo
ui-edit-redo = Redo
ui-view-theme = Theme
ui-view-text-size = Text size
ui-theme-dark = Dark
ui-theme-light = Light
ui-theme-projector = Projector
ui-text-percent = { $percent } %
ui-help-keys = Keys
ui-help-hints = Hints for the start
ui-hints-close = Close the hints; the help menu has them
ui-hint-drag = Drag a ring or a square: every number of every stage follows.
ui-hint-step = Step with → and ←: the lit line says what was done.
ui-hint-pixel = Click a pixel of the image: it tells why it is drawn or not.
ui-lecture = { $count ->
    [one] Lecture: { $heading }
   *[other] Lectures ({ $count }): { $heading }
}
ui-lectures = In the lectures
ui-view-exact = Exact values, with their bits
ui-view-still = Less motion
ui-key-exact = Exact values, with their bits

ui-palette = Commands
ui-palette-hint = Type what you want to do
ui-palette-none = No command has these words.
ui-palette-overlay = On the image: { $name }
ui-palette-theme = Theme: { $name }
ui-palette-text-size = Text size: { $name }
ui-palette-level = Size of a step: { $name }
ui-palette-lab = Open: { $name }
ui-palette-preset = Preset: { $name }
ui-unit-line = line
ui-unit-point = point
ui-unit-polygon = { $count ->
    [one] polygon
   *[other] polygons
}
ui-unit-objects = { $count ->
    [one] object
   *[other] objects
}

ui-stage-off = off
ui-stage-earlier = { $count } { $count ->
    [one] earlier stage
   *[other] earlier stages
}
ui-stage-later = { $count } { $count ->
    [one] later stage
   *[other] later stages
}

ui-algorithm = Algorithm: { $name }
ui-presets = Preset
ui-conventions = Conventions
ui-arithmetic = Arithmetic
ui-snap = Snap
ui-snap-half = halves
ui-snap-centre = pixel centres
ui-snap-off = off
ui-mistakes = Common mistakes
ui-point-and-window = Point and window
ui-ends-and-corners = Ends and corners
ui-stays-convex = The window stays convex: a corner that would bend inward stops.
ui-corners-and-window = Corners and window
ui-add-corner = Add a corner
ui-add-corner-where = In the middle of the longest edge
ui-remove-corner = Remove one
ui-remove-corner-where = The last corner; three must stay
ui-side-order = Sides
ui-ends-and-window = Ends and window

ui-tab-step = Step
ui-tab-listing = Listing
ui-tab-values = Values
ui-tab-pixel = Pixel
ui-inspector-empty = Here stands what each step does, once there is something to step.
ui-listing-hint = Go to the next execution of this line
ui-changed = changed in this step
ui-more-rows = { $count } more { $count ->
    [one] row
   *[other] rows
}

ui-canvas = Canvas
ui-canvas-empty = No triangle yet. Choose a preset, or open a file.
ui-readout-pixel = ({ $x }, { $y })  centre { $centre }
ui-readout-depth = depth { $depth }
ui-readout-code = code { $code }
ui-readout-by = by { $name }
ui-readout-clear = clear
ui-readout-fragments = { $written } of { $generated } { $generated ->
    [one] fragment
   *[other] fragments
} written
ui-readout-triangle = triangle { $number } of { $count } in { $name }
ui-scenery-skips = Skips
ui-overlay = On the image
ui-overlay-is = { ui-overlay }: { $name }
ui-busy-overlay = Counting what lies on the image
ui-readout-value = value { $value }
ui-readout-point = { $at }

ui-timeline-begin = To the start
ui-timeline-back = Step back
ui-timeline-play = Play
ui-timeline-pause = Pause
ui-timeline-forward = Step forward
ui-timeline-end = To the end
ui-timeline-scrub = Step of the run
ui-timeline-level = Size of a step
ui-timeline-speed = Steps a second
ui-timeline-per-second = { $speed } /s
ui-level-primitive = primitive
ui-level-row = row
ui-level-detail = detail
ui-key-home = Home
ui-key-space = Space
ui-key-end = End
ui-key-play = Play, pause
ui-key-next-algorithm = Next algorithm of the stage
ui-key-last-algorithm = Algorithm before, of the stage
ui-key-fit = Fit the drawing into the canvas
ui-key-overlay = What lies on the image
ui-key-theme = Next theme
ui-key-bigger = Bigger
ui-key-smaller = Smaller
ui-key-normal = Normal size
ui-key-escape = Put a drag back, close what lies on top
ui-key-tab = Next control or handle
ui-key-arrows = Move the handle that has the focus
ui-key-alt = Hold while dragging: no snapping
ui-close = Close

ui-open = Open
ui-save = Save
ui-cancel = Cancel
ui-dismiss = Dismiss
ui-choose-file = Choose a file…
ui-path-open = Open the file
ui-path-save = Save as
ui-path-picture = Export the picture (.svg, .png) or the values (.csv) to
ui-path-film = Export the run to (.png)
ui-unsaved = There are unsaved edits.
ui-discard = Discard
ui-later = Later
ui-bring-back = Bring it back
ui-large = This window is large. Make everything half as big again? The view menu has more sizes.
ui-large-yes = 150 %
ui-large-no = Not now
ui-work-back = The unsaved work of last time is back.
ui-work-aside = There is unsaved work of last time.
ui-no-picture = There is nothing on the canvas to export.
ui-picture-ending = A picture's name ends in .svg or .png, that of values in .csv.
ui-film-ending = An animated picture's name ends in .png or .apng.
ui-film-busy = An animated picture is being made: wait for it, or stop it first.
ui-film-frame = Animated picture: frame { $number } of { $all }
ui-film-saved = Saved to { $path }: { $frames ->
    [one] one frame
   *[other] { $frames } frames
}.
ui-film-stopped = The animated picture was stopped: nothing was written.
ui-busy-open = Opening { $name }
ui-busy-image = Computing the image
ui-busy-run = Tracing the steps
ui-stop = Stop
ui-lost = This could not be done: the work ended with a fault of the program.
ui-copied-picture = The picture is on the clipboard.
ui-copy-value = A click copies the value.
ui-copied-value = { $value } is on the clipboard.
ui-copied-values = The values are on the clipboard.
ui-error-keep = Unsaved work cannot be kept for the next start: { $reason }. Save it to a file.
ui-no-dialog = There is no file dialog here: type the path, or drop the file on the window.
ui-saved = Saved to { $path }.
ui-error-read = { $path } cannot be read: { $reason }. Check the path, then open it again.
ui-error-write = { $path } cannot be written: { $reason }. Save under another path.
ui-near-plane = near plane
ui-vertices-homogeneous = Corners (x w, y w, w)
ui-show-visits = order of the tests
ui-pixel-click = Click a pixel of the drawing: here stands which edge lets it in or keeps it out.
ui-pixel-none = Click a pixel of the picture: here stands what happened to it.

ui-fill-rule = Tie rule
ui-winding = Inside
ui-corners = Corners (pixels)
ui-ends-pixels = Ends (pixels)
ui-point-pixels = Point (pixels)
ui-point-size = Size
ui-unit-pixels = px
ui-depth-format = Depth
ui-depth-range = Range
ui-object = Object
ui-vertex = Vertex
ui-triangle = Triangle
ui-triangle-of-scene = Triangle of the scene
ui-vertices-pixels = Vertices (pixels)
ui-vertices-depth = Vertices (pixels, depth)
ui-vertices-w = Vertices (pixels, w)
ui-mode = Mode
ui-squares = Squares
ui-samples = Samples
ui-shading = Shading
ui-vertices-shade = Vertices (pixels, shade)
ui-corners-camera = Corners (camera space)
ui-line-pixels = Line (pixels)

ui-y-axis = y axis
ui-front = Front
ui-cull = Cull
ui-placing = Object to world
ui-move = move
ui-turn = turn
ui-scale = scale
ui-camera = Camera
ui-eye = eye
ui-target = at
ui-up = up
ui-fovy = fovy
ui-height = height
ui-near = near
ui-far = far
ui-objects = Objects, in drawing order
ui-object-name = Name of object { $number }
ui-object-color = Colour
ui-object-earlier = Draw object { $number } earlier
ui-object-later = Draw object { $number } later
ui-object-remove = Remove object { $number }
ui-object-add = Add a triangle
ui-skips = Work left out, image unchanged
ui-skip-object-frustum = Objects outside
ui-skip-frustum = Triangles outside
ui-skip-back-face = Back faces early
ui-skip-degenerate = No area early
ui-skip-tile = Tiles not touched
ui-skip-row = Row ends
ui-skip-early-z = Early depth test
ui-skip-hierarchical-z = Hidden blocks
ui-skip-deferred = Colours drawn over
ui-skip-clear = Untouched pixels
ui-skip-memo = Unchanged stages
ui-outlines = Outlines
ui-scenery-image = Image
ui-scenery-space = Space
ui-image-size = { $width } × { $height } pixels
ui-readout-space = drag: orbit   Shift + drag: move   wheel: zoom   F: frame all
ui-pixel-title = Pixel ({ $x }, { $y })
ui-pixel-clear = Clear
ui-pixel-clear-depth = depth { $depth }
ui-stages = Stages
column-came = in
column-went = out
column-dropped = dropped
ui-thousands = { $count } k

ui-compare = Compare with…
ui-compare-hint = Type what the other side should have
ui-compare-nothing = This lab has nothing to be compared with.
ui-compare-setting = { $setting }: { $value }
ui-palette-compare = Compare with { $name }
ui-split-view = Split view
ui-split-leave = One side
ui-split-handle = { $name } on side B
ui-tab-difference = Difference
ui-difference-none = No difference
ui-difference-equal = { $count ->
    [0] Neither side has a result.
    [one] Both sides have the same single part, bit for bit.
   *[other] All { $count } parts of the two results are the same, bit for bit.
}
ui-difference-pixels = **{ $count }** { $count ->
    [one] pixel differs
   *[other] pixels differ
}
ui-difference-parts = **{ $count }** { $count ->
    [one] part differs
   *[other] parts differ
}
ui-difference-changed = in both, but different
ui-difference-only-a = only in A
ui-difference-only-b = only in B
ui-difference-number = in both, another number
ui-difference-farthest = Numbers differ by at most { $ulps } ULP (steps between 32-bit floats).
ui-difference-counts = Counts
ui-difference-list = What differs
ui-count-steps = steps
ui-count-comparisons = comparisons
ui-count-multiplications = multiplications
ui-count-divisions = divisions
ui-part-answer = Answer
ui-part-corner = Corner { $at }
ui-part-corner-short = corner
ui-part-pixel = Pixel ({ $x }, { $y }), centre { $centre }
ui-part-there = there
ui-part-neither = Neither side has it.
ui-part-only = Only side { $side } has it ({ $name }: { $value }).
ui-part-same = Both sides have it, with the same values.
ui-part-differs = Both sides have it, with different values.
ui-part-ulps = The numbers are { $ulps } ULP apart.
ui-space = Space
ui-outline = Outlines
ui-outlines-drawn = Drawn
ui-outline-factor = Factor
ui-outline-distance = Distance
ui-outline-pixels = Pixels
ui-stencil-of = Stencil state of { $object }
ui-stencil-test = Stencil test
ui-stencil-compare = Compare
ui-stencil-fail = failOp
ui-stencil-depth-fail = depthFailOp
ui-stencil-pass = passOp
ui-stencil-reference = Reference
ui-stencil-read-mask = Read mask
ui-stencil-write-mask = Write mask
ui-blend-mode = Blending
ui-blend-order = Order
ui-blend-own = own factors
ui-blend-color = Colour
ui-blend-alpha = Alpha
ui-blend-source-factor = srcFactor
ui-blend-destination-factor = dstFactor
ui-blend-operation = operation
ui-blend-constant = Constant
ui-blend-clear = Cleared to
ui-blend-layers = Layers: r, g, b, α
ui-blend-depths = Depths
ui-layer-add = Add a layer
ui-layer-remove = Remove the last
ui-depth-test = Test
ui-depth-write = Write depths that pass
ui-depth-clear = Cleared to
ui-depth-reversed = Reversed: near is 1
ui-fragments = Fragments
ui-fragments-of = Of
ui-bias-constant = Bias, steps
ui-bias-slope = Bias, slopes
ui-bias-clamp = Bias limit
ui-bias-counts = Bias counts
ui-unclipped = Near and far clamp instead of clipping
ui-scissor = Scissor rectangle
ui-alpha-test = Alpha test
ui-alpha-compare = Keep if alpha
ui-alpha-reference = Reference
ui-alpha-vertices = α
ui-early-z = Early z where it may be
ui-key-pixel = Choose the next pixel
ui-pixel-go = Go to
ui-precision-distances = Distances
ui-precision-near = Near
ui-precision-far = Far
ui-precision-gap = Gap
ui-planes = Planes
ui-guard = Factor
ui-pieces = Result
ui-vertices-camera = Vertices (camera space)
ui-vertices-and-plane = Vertices, plane

ui-shade-model = Highlight
ui-shade-two-sided = Both sides are lit
ui-shade-far = Light is infinitely far
ui-shade-places = Places (world space)
ui-shade-light = Light
ui-shade-intensity = Intensity
ui-shade-material = Material
ui-shade-exponent = Exponent s
ui-shade-shade = Shading
ui-shade-model-of-all = Highlights
ui-shade-lights = Lights
ui-shade-headlight = None: a light stands in the eye.
ui-shade-add-light = Add a light
ui-shade-remove-light = Remove L{ $number }

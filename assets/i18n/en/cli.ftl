# The command line: what is wrong with a request, a file or an option.

error-output = Cannot write to standard output: { $why }.
error-input = Cannot read standard input to its end: { $why }.

word-does-not-exist = it does not exist
word-no-permission = no permission
word-is-a-folder = it is a folder
word-is-no-folder = one of its folders is a file
word-read-only = the disk is read-only
word-file-read-only = the file is read-only
word-is-in-the-way = a file of this name is in the way
word-disk-full = the disk is full
word-too-large = it is too large

error-not-utf8 = Not UTF-8: byte { $byte } starts no character.
error-empty-request = There is no request: write one JSON object, such as {"{"}"op":"clip_line", …{"}"}.
error-not-an-object = A request is one JSON object, in braces, with at least the field op.
error-too-long = Longer than { $megabytes } MB: a request that long is not read.
error-json = Not JSON from line { $line }, column { $column } on.
error-json-ends = The JSON ends too early, at line { $line }, column { $column }.
error-json-too-deep = Nested too deeply at line { $line }, column { $column }: at most 127 levels are read.
error-json-number = The number at line { $line }, column { $column } is too large for binary64.
error-json-nan = NaN and infinities are no numbers of JSON: line { $line }, column { $column }.
error-json-fraction = A number needs a digit before its point, such as 0.5: line { $line }, column { $column }.

error-missing-field = The field { $field } is missing.
error-not-a-text = { $field } must be a text in quotes.
error-not-a-number = { $field } must be a number.
error-not-a-list = { $field } must be a list in brackets.
error-not-skips = { $field } must be "all", "none" or a list of names in brackets.
error-list-length = { $field } must hold { $wanted ->
    [one] one value
   *[other] { $wanted } values
}, not { $count }.
error-too-large = { $field } rounds to an infinite binary32 number: at most about 3.4 × 10³⁸ is allowed.
error-too-far = { $field } must lie within { $most } pixels of the origin: clip the line first.
error-bad-samples = { $field } must be 1, 2, 4 or 8.
error-bad-size = { $field } must be two whole numbers from 1 to 16384, together at most 2²⁸ pixels.
error-too-few-corners = { $field } must hold at least 3 corners, not { $count }.
error-empty-window = { $field } must be [xmin, ymin, xmax, ymax] with no minimum above its maximum.
error-unknown-name = { $field } cannot be { $name }. Known: { $known }.
error-unsupported = { $field } { $name } is not there yet; it comes in a later version.
error-overflow = In { $arithmetic } arithmetic the result is no finite number. Use exact.
error-request-without-steps = A { $op } request has no steps to go through.

error-cannot-read = Cannot read { $file }: { $why }.
error-file-not-found = Cannot read { $file }: { $why }. Check the name; "rasterscope list" shows what is built in.
error-cannot-write = Cannot write { $file }: { $why }. Choose another place.
error-no-folder = Cannot write { $file }: the folder { $folder } does not exist. Make it first, or choose another.
error-in-file = { $file }: { $problem }
error-request-is-no-scene = { $file } holds a compute request, not a scene. Run "rasterscope compute { $file }".
error-no-input-for-lab = { $file } has no input for { $lab }. Give a scene that opens this lab, or a compute request for it.
error-unknown-lab = There is no lab { $lab }. Known: { $known }.
error-bench-file = bench { $what } measures inputs of its own: leave out { $file }, or ask for bench skips { $file }.
error-bench-ending = { $file } must end in .svg, .png, .csv or .json.
error-figure-ending = { $file } must end in .svg or .png.
error-animation-ending = { $file } must end in .png or .apng: an animated picture is an animated PNG.
error-skips-changed = A skip changed a byte of colour, depth or stencil: please report this scene.
error-figure-overlay = Only the image at the end of the lab pipeline has overlays: leave out --step or --overlay.
error-figure-size = The size must be WIDTHxHEIGHT, each from 16 to 8192.

cli-labs = Labs (trace ALGORITHM FILE, figure LAB FILE)
cli-step-past-the-end = The run has { $steps ->
    [one] one step
   *[other] { $steps } steps
}, fewer than { $asked }: the picture shows its end.
cli-frames = Frame { $number } of { $all }
cli-presets = Presets (as FILE)

# The program: its commands, and why there is no window

app-about = A debugger for the triangle rendering pipeline.
app-file = A scene, an OBJ model or a preset to open in the window.
app-compute = Answer one JSON request, or one a line from standard input.
app-compute-file = The request; left out with --lines.
app-compute-lines = One request a line from standard input, one answer a line.
app-trace = Write the events of a run, one a line.
app-trace-algorithm = Which algorithm: see list.
app-scene-or-request = A scene or a compute request.
app-trace-format = For people or for programs.
app-figure = Draw a step of a lab, the same as in the window.
app-figure-lab = Which lab: see list.
app-figure-step = After how many steps; 0 is the start, left out the end.
app-figure-size = Width and height in points.
app-figure-theme = In which colours.
app-figure-output = Where the picture goes: .svg or .png.
app-tour = Write a web page that walks a scene through every stage.
app-tour-file = A scene, a model or a preset.
app-tour-output = The folder of the page; it is made if it is not there.
app-list = List labs, algorithms and presets.
app-error-size = write width x height, such as 960x720
app-no-display = The window cannot be opened: there is no display.
app-no-gui = This program was built without its window.
app-no-window = The window cannot be opened: { $reason }.
app-missing-library = The window cannot be opened: a system library is missing. On Debian and Ubuntu, `sudo apt install { $package }` installs it.
app-tour-instead = The tour of the scene was written instead: { $path }.
app-no-such-command = { $name } is neither a command nor a file. "rasterscope --help" lists the commands, "rasterscope list" the presets.

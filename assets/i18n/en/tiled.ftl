# Tiles

tiled = Tiles
tiled-about = Draw or leave out whole squares of 64, 16 and 4 pixels; test centres only where an edge passes.

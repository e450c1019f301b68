# Words that several areas share: headings of columns and names of things.

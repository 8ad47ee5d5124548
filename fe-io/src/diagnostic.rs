//! Messages about a deck or a mesh: file, line, caret, nearest known word.

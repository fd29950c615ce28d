"""The line-scan room: motion, length and gaps of vehicles from a pair of strips. Arrays in, results out."""

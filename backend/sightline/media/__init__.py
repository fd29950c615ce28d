"""The only place that opens video and images, keeps files, and knows what "frame n" means.

Frame n of a recording is the n-th frame that a sequential decode puts out; the frame table (time stamp,
key flag, checksum of the luma as decoded) is its identity. Nothing here knows SQL, HTTP or geometry: it
takes paths and arrays and gives back frozen dataclasses.
"""

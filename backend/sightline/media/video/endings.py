"""How the names of video files end."""

# fmt: off
VIDEO_ENDINGS = frozenset((
    ".3gp", ".asf", ".avi", ".h264", ".hevc", ".m2ts", ".m4v", ".mkv", ".mov", ".mp4", ".mpeg", ".mpg",
    ".mts", ".mxf", ".ts", ".webm", ".wmv",
))
# fmt: on

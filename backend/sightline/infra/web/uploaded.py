"""Files that come with a form or an upload: what they are called, and small ones whole."""

from pathlib import PurePosixPath

from fastapi import UploadFile

from sightline.errors import BadInput

MOST_NAME = 400


def clean_name(name: str) -> str:
    """The last part of a path, without control characters, of a length that can be stored."""
    last = PurePosixPath(name.replace("\\", "/")).name
    readable = "".join(letter for letter in last if letter.isprintable()).strip()
    return readable[-MOST_NAME:] or "recording"


def whole_file(file: UploadFile, most_bytes: int, name: str) -> bytes:
    """The content of a small uploaded file. Raises BadInput for one that is too large."""
    content = file.file.read(most_bytes + 1)
    if len(content) > most_bytes:
        raise BadInput("web-too-large", name=name, most_bytes=most_bytes // 1000000)
    return content

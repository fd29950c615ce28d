"""The geometry room: cameras, boards, road poses and heights. Pure: arrays in, dataclasses out."""

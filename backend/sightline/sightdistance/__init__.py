"""What heights of eyes, objects and headlights mean for a road: sight distances and the curves that keep
them.
"""

"""What heights of eyes, objects and headlights mean for a road: sight distances and curves that keep them."""

"""Pure statistics: errors against reference heights. Arrays in, frozen dataclasses out."""

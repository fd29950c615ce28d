"""Numbers of vehicles in sentences."""


def vehicles(n: int) -> str:
    """ "1 vehicle", "2 vehicles"."""
    return f"{n} vehicle" if n == 1 else f"{n} vehicles"


def there_are(n: int) -> str:
    """ "there is 1", "there are 2", "there is none"."""
    return "there is none" if n == 0 else f"there {'is' if n == 1 else 'are'} {n}"


def are_too_few(n: int) -> str:
    """ "1 vehicle is too few", "2 vehicles are too few"."""
    return f"{vehicles(n)} {'is' if n == 1 else 'are'} too few"

"""Which model of the catalogue a vehicle can be, by what was measured of it."""

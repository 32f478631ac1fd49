"""The parts of the search for a first touch: when is a ball in a band, which ends bound its gap, when does it touch one?"""

"""Heights that standards of road design are set by, to be drawn into distributions. An editable beginning.

Nothing here was read in the standards themselves unless `cited_by` is empty: it says who cites the value,
or that nobody was seen to. A percentile is the rule behind a value where a source states it.
"""

from dataclasses import dataclass

from sightline.enums import StandardHeight


@dataclass(frozen=True)
class Standard:
    """One height of one standard.

    `what`: what it is a height of; `percent`: which percentile of `vehicle_class` it stands for, None where
    no source says; `cited_by`: who cites it, "" where the source itself was read; `drawn`: whether
    distributions are read against it (not what is superseded, nor the upper end of a range).
    """

    name: str
    what: StandardHeight
    height_m: float
    source: str
    edition: str = ""
    year: int | None = None
    percent: float | None = None
    vehicle_class: str = ""
    cited_by: str = ""
    drawn: bool = True


GREEN_BOOK = "A Policy on Geometric Design of Highways and Streets"
FITZPATRICK = "Fitzpatrick, Lienau and Fambro, Transportation Research Record 1612, 1998"
DUPUIS = "Dupuis et al., Sensors 2019"
ROGERS = "Rogers, Highway Engineering, 2003"
UNSEEN = "no text consulted; check before use"
_CARS = "passenger cars"
_LAMPS = "taillights of passenger cars"

STANDARDS = (
    Standard(
        name="AASHTO (USA)",
        what="eye_car",
        height_m=1.08,
        source=f"{GREEN_BOOK}, after {FITZPATRICK}",
        edition="2011",
        year=2011,
        percent=10.0,
        vehicle_class=_CARS,
        cited_by=f"{DUPUIS}; the percentile by the abstract of Fitzpatrick et al.",
    ),
    Standard(
        name="AASHTO (USA)",
        what="object_stopping",
        height_m=0.60,
        source=f"{GREEN_BOOK}, after {FITZPATRICK}",
        edition="2011",
        year=2011,
        percent=5.0,
        vehicle_class=_LAMPS,
        cited_by=f"{DUPUIS}; the percentile by the abstract of Fitzpatrick et al.",
    ),
    Standard(
        name="AASHTO (USA)",
        what="object_passing",
        height_m=1.08,
        source=GREEN_BOOK,
        edition="2011",
        year=2011,
        cited_by=DUPUIS,
    ),
    Standard(
        name="AASHTO (USA)",
        what="eye_truck",
        height_m=2.33,
        source=GREEN_BOOK,
        vehicle_class="trucks",
        cited_by=UNSEEN,
    ),
    Standard(
        name="AASHTO (USA)",
        what="headlight",
        height_m=0.60,
        source=f"sags; {FITZPATRICK}",
        year=1998,
        percent=10.0,
        vehicle_class="headlights of passenger cars",
        cited_by="the abstract of Fitzpatrick et al., who recommend it",
    ),
    Standard(
        name="Fitzpatrick et al. (proposed)",
        what="vehicle",
        height_m=1.315,
        source=FITZPATRICK,
        year=1998,
        percent=10.0,
        vehicle_class=_CARS,
        cited_by="the abstract of Fitzpatrick et al.",
    ),
    Standard(
        name="AASHTO (USA), 2000",
        what="eye_car",
        height_m=1.07,
        source=GREEN_BOOK,
        edition="2000",
        year=2000,
        cited_by=DUPUIS,
        drawn=False,
    ),
    Standard(
        name="AASHTO (USA), 1965",
        what="eye_car",
        height_m=1.15,
        source="AASHTO's policy of the time",
        edition="1965",
        year=1965,
        cited_by=DUPUIS,
        drawn=False,
    ),
    Standard(
        name="AASHTO (USA), 1920",
        what="eye_car",
        height_m=1.65,
        source="first proposals; 1676 mm by Fitzpatrick et al.",
        edition="1920",
        year=1920,
        cited_by=DUPUIS,
        drawn=False,
    ),
    Standard(
        name="United Kingdom",
        what="eye_car",
        height_m=1.05,
        source="Design Manual for Roads and Bridges, TD 9/93 (now CD 109)",
        edition="TD 9/93",
        year=1993,
        percent=5.0,
        vehicle_class="drivers",
        cited_by=f"{ROGERS}: more than 95 % of drivers' eyes are higher",
    ),
    Standard(
        name="United Kingdom",
        what="eye_truck",
        height_m=2.00,
        source="Design Manual for Roads and Bridges, TD 9/93 (now CD 109)",
        edition="TD 9/93",
        year=1993,
        vehicle_class="large heavy goods vehicles, typical",
        cited_by=ROGERS,
    ),
    Standard(
        name="United Kingdom, low",
        what="object_stopping",
        height_m=0.26,
        source="Design Manual for Roads and Bridges, TD 9/93 (now CD 109); Dupuis et al. print 0.25 m",
        edition="TD 9/93",
        year=1993,
        cited_by=ROGERS,
    ),
    Standard(
        name="United Kingdom, high",
        what="object_stopping",
        height_m=2.00,
        source="Design Manual for Roads and Bridges, TD 9/93 (now CD 109): the upper end of a range",
        edition="TD 9/93",
        year=1993,
        cited_by=ROGERS,
        drawn=False,
    ),
    Standard(
        name="France",
        what="eye_car",
        height_m=1.00,
        source="ICTAAL",
        edition="2000",
        year=2000,
        percent=2.5,
        vehicle_class="passenger cars of the study of Fambro et al. 1997",
        cited_by=DUPUIS,
    ),
    Standard(
        name="France",
        what="object_stopping",
        height_m=0.60,
        source="ICTAAL",
        edition="2000",
        year=2000,
        percent=10.0,
        vehicle_class="lower limit of rear lamps, a toll station near Paris",
        cited_by=DUPUIS,
    ),
    Standard(
        name="Italy",
        what="eye_car",
        height_m=1.10,
        source="CNR standards of 1973",
        year=1973,
        cited_by="Capaldo, Procedia Social and Behavioral Sciences 53, 2012",
    ),
    Standard(
        name="Australia",
        what="eye_truck",
        height_m=2.40,
        source="Austroads, Guide to Road Tunnels Part 2, 4.5.2 (sags under a roof)",
        vehicle_class="trucks",
    ),
    Standard(
        name="Australia",
        what="object_stopping",
        height_m=0.80,
        source="Austroads, Guide to Road Tunnels Part 2, 4.5.2 (taillight of a car)",
        vehicle_class="taillights of cars",
    ),
    Standard(
        name="Australia",
        what="eye_car",
        height_m=1.10,
        source="Austroads, Guide to Road Design Part 3",
        cited_by=UNSEEN,
    ),
    Standard(
        name="Australia, 1991",
        what="eye_car",
        height_m=1.15,
        source="design value of the time",
        year=1991,
        cited_by="the abstract of Barker and Yue, Australian Road Research 21(2), 1991",
        drawn=False,
    ),
    Standard(
        name="Germany",
        what="eye_car",
        height_m=1.00,
        source="RAL (formerly RAS-L)",
        cited_by=UNSEEN,
    ),
    Standard(
        name="Germany",
        what="eye_truck",
        height_m=2.50,
        source="RAL (formerly RAS-L)",
        vehicle_class="trucks",
        cited_by=UNSEEN,
    ),
    Standard(
        name="Israel",
        what="eye_car",
        height_m=1.05,
        source="national guidelines",
        cited_by=UNSEEN,
    ),
    Standard(
        name="Israel, low",
        what="object_stopping",
        height_m=0.15,
        source="national guidelines",
        cited_by=UNSEEN,
    ),
)

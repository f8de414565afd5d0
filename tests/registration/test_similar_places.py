"""Streets of equal width share ground and facades. The details decide whether two submaps show the same place."""

import pytest

from pointloom.registration.evidence import Details
from pointloom.registration.lidar.submap_pairs import MIN_PLACE_SCORE, score_of_details

# Measured at poses whose score without this limit was 0.80 to 0.93, although the submaps are of different cities
OTHER_PLACES = {
    "two decks, 32 beams": Details(0.41, 0.19, 930, 0.22, 5934, 303),
    "street and deck, 32 beams": Details(0.39, 0.20, 1418, 0.59, 4602, 563),
    "street beside a deck, 32 beams": Details(0.36, 0.14, 1044, 0.37, 4180, 708),
    "another street of one city, 64 beams": Details(0.51, 0.19, 315, 0.39, 2733, 167),
}
# Measured at right poses: the ones nearest to the limit, and surfaces without relief
SAME_PLACES = {
    "KITTI scans 17 m apart": Details(0.37, 0.19, 129, 0.52, 600, 19),
    "KITTI scans 11 m apart": Details(0.42, 0.23, 525, 0.62, 1702, 68),
    "submap with scans at rest": Details(0.61, 0.51, 2163, 0.76, 4766, 537),
    "Livox Avia, smooth walls": Details(0.50, 0.41, 222, 0.20, 429, 5),
    "smooth walls, no pair that contradicts": Details(0.9, 0.6, 300, 0.0, 3000, 0),
}


@pytest.mark.parametrize("details", OTHER_PLACES.values(), ids=OTHER_PLACES)
def test_details_that_contradict_each_other_reject_a_place(details):
    assert score_of_details(details) < MIN_PLACE_SCORE - 0.2


@pytest.mark.parametrize("details", SAME_PLACES.values(), ids=SAME_PLACES)
def test_details_of_one_place_accept_it(details):
    assert score_of_details(details) > MIN_PLACE_SCORE + 0.1


def test_the_score_rises_with_each_kind_of_agreement():
    base = Details(0.4, 0.2, 500, 0.5, 2000, 100)
    changes = ({"rest": 0.3}, {"matches": 800.0}, {"relief": 0.7}, {"contrary": 60.0})
    better = [base._replace(**change) for change in changes]
    assert all(score_of_details(one) > score_of_details(base) for one in better)
    assert score_of_details(None) == 0 and score_of_details(base._replace(rest=0.0)) < 1e-6

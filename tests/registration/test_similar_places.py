"""Streets of equal width share ground and facades. The details decide whether two submaps show the same place."""

import pytest

from pointloom.registration.evidence import Details, Evidence
from pointloom.registration.lidar.submap_pairs import MIN_PLACE_SCORE, score_of_details


def evidence_of(matches, *details):
    return Evidence(0.4, 0.05, matches, details=Details(*details))


# Measured at poses whose score without this limit was 0.80 to 0.96, although the submaps are of different cities
OTHER_PLACES = {
    "two decks, 32 beams": evidence_of(6255, 0.41, 0.19, 930, 0.22, 5934, 303),
    "street and deck, 32 beams": evidence_of(5465, 0.39, 0.20, 1418, 0.59, 4602, 563),
    "street beside a deck, 32 beams": evidence_of(4937, 0.36, 0.14, 1044, 0.37, 4180, 708),
    "the nearest to the limit, 32 beams": evidence_of(5700, 0.40, 0.23, 1633, 0.65, 4719, 453),
    "another street of one city, 64 beams": evidence_of(3668, 0.51, 0.19, 315, 0.39, 2733, 167),
}
# Measured at right poses: the ones nearest to the limit, and surfaces without relief
SAME_PLACES = {
    "KITTI scans 17 m apart": evidence_of(1027, 0.37, 0.19, 129, 0.52, 600, 19),
    "KITTI scans 11 m apart": evidence_of(2328, 0.42, 0.23, 525, 0.62, 1702, 68),
    "submap with scans at rest": evidence_of(7108, 0.61, 0.51, 2163, 0.76, 4766, 537),
    "Livox Avia, smooth walls": evidence_of(752, 0.50, 0.41, 222, 0.20, 429, 5),
    "smooth walls, no pair that contradicts": evidence_of(3000, 0.9, 0.6, 300, 0.0, 3000, 0),
}


@pytest.mark.parametrize("evidence", OTHER_PLACES.values(), ids=OTHER_PLACES)
def test_details_that_contradict_each_other_reject_a_place(evidence):
    assert score_of_details(evidence) < MIN_PLACE_SCORE - 0.1


@pytest.mark.parametrize("evidence", SAME_PLACES.values(), ids=SAME_PLACES)
def test_details_of_one_place_accept_it(evidence):
    assert score_of_details(evidence) > MIN_PLACE_SCORE + 0.05


def test_the_score_rises_with_each_kind_of_agreement():
    base = Details(0.4, 0.2, 500, 0.5, 2000, 100)
    changes = ({"rest": 0.3}, {"matches": 800.0}, {"relief": 0.7}, {"contrary": 60.0})
    better = [base._replace(**change) for change in changes]
    scores = [score_of_details(Evidence(0.4, 0.05, 3000, details=one)) for one in (base, *better, None)]
    assert all(score > scores[0] for score in scores[1:-1]) and scores[-1] == 0

"""Units of length: what names and lengths mean, what files may write, where the user is warned."""

import copy
import pickle
import warnings

import pytest

import pointloom as loom
from pointloom.core.units import (
    DEGREE,
    FOOT,
    KNOWN,
    METRE,
    US_FOOT,
    LengthUnit,
    common_unit,
    symbol_of,
    text_of,
    unit_by_length,
    unit_by_name,
    unit_of_text,
)

LINK = LengthUnit("Gunter's link", "li", 0.201168)


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("metre", METRE), ("Meter", METRE), ("m", METRE), ("foot", FOOT), ("FEET", FOOT), ("ft", FOOT),
        ("US survey foot", US_FOOT), ("Foot_US", US_FOOT), ("foot_survey_us", US_FOOT), ("US ft", US_FOOT),
        ("us-ft", US_FOOT), ("International Foot", FOOT), ("deg", DEGREE), ("furlong", None), ("", None),
    ],
)  # fmt: skip
def test_units_go_by_the_names_that_are_in_use(name, unit):
    assert unit_by_name(name) is unit


@pytest.mark.parametrize(
    ("name", "meters", "unit"),
    [
        ("metre", 1.0, METRE),
        ("foot", 0.3048, FOOT),
        ("foot", 0.30480060960121924, US_FOOT),  # many files call the survey foot so; its length is what counts
        ("US survey foot", 0.304801, US_FOOT),  # of few digits
        ("whatever", 0.3048, FOOT),
        ("metre", 0.3048, None),  # the two contradict each other
        ("foot", 1.0, None),
        ("degree", 0.0174532925199433, None),
        ("metre", float("nan"), None),
        ("metre", 0.0, None),
    ],
)
def test_a_unit_is_defined_by_its_length_unless_its_name_differs(name, meters, unit):
    assert unit_by_length(name, meters) is unit


def test_an_unknown_name_with_a_length_is_a_unit_of_its_own():
    unit = unit_by_length("Clarke's link", 0.201166195164)
    assert (unit.name, unit.symbol, unit.meters) == ("Clarke's link", "Clarke's link", 0.201166195164)
    assert unit_by_length("pied\u00e9", 0.3249).name == "unit of 0.3249 m"  # not representable in an ASCII header


@pytest.mark.parametrize("unit", [*KNOWN, LINK], ids=str)
def test_a_unit_survives_text_pickles_and_copies(unit):
    for back in (unit_of_text(text_of(unit)), pickle.loads(pickle.dumps(unit)), copy.deepcopy(unit)):
        assert back == unit and hash(back) == hash(unit) and back.meters == unit.meters
    assert unit == unit.name and unit != "ell" and unit != 3


@pytest.mark.parametrize("text", ["feet", "mm", "metre = 0.3048 m", "x = 1 ft", "x = m", "x = nan m", "of a scan", ""])
def test_other_text_is_no_unit(text):
    assert unit_of_text(text) is None


def test_one_unit_is_common_and_two_are_a_warning_at_the_users_line():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert common_unit("clouds", [None, FOOT, None, FOOT]) is FOOT
        assert common_unit("clouds", [None, None]) is None
    with pytest.warns(loom.UnitWarning, match=r"^clouds:.*to_unit") as caught:
        assert common_unit("clouds", [METRE, None, FOOT]) is None
    assert caught[0].filename == __file__
    with pytest.warns(loom.UnitWarning, match="project_to_utm"):
        common_unit("clouds", [METRE, DEGREE])
    with pytest.warns(loom.UnitWarning, match=r"^clouds:"):  # 2e-6 apart: 1.3 m at a state plane's 2,000,000 ft
        common_unit("clouds", [US_FOOT, FOOT])


def test_lengths_in_unknown_units_are_reported_in_meters():
    assert [symbol_of(unit) for unit in (None, METRE, US_FOOT, LINK)] == ["m", "m", "US ft", "li"]

"""Compare the creep of a light box on a heavy turntable in releases of MuJoCo C."""

from measured_report.files.columns import PLAIN
from report.shared import (
    PERCENT,
    Claim,
    Results,
    Section,
    all_of,
    at_least,
    at_most,
    extreme,
    largest_size,
    table_of,
)

order = 190
page = "scenes"
label = "light on heavy"
OLD = "3.10.0"
SETTINGS = {
    "implicitfast": "implicitfast",
    "strict": "strict tolerance",
    "cold": "no warm start",
    "euler": "Euler",
}


def derive(results: Results) -> Section:
    releases = [row.release for row in results.rows if row.case.endswith("-euler")]
    rates = {
        setting: [
            results.value(
                f"rate_{setting}_{release}",
                "growth of the distance from the axis",
                PERCENT * results.row[f"{release}-{setting}"].growth_per_s,
            )
            for release in releases
        ]
        for setting in SETTINGS
    }

    offs = {
        (setting, release): results.value(
            f"off_{setting}_{release}",
            "difference from the rate with Euler, relative to the latter",
            PERCENT * (rate / euler - 1),
        )
        for setting in SETTINGS
        for release, rate, euler in zip(
            releases, rates[setting], rates["euler"], strict=True
        )
    }
    newer = [offs["implicitfast", release] for release in releases if release != OLD]
    right = [
        cell
        for (setting, release), cell in offs.items()
        if setting != "implicitfast" or release == OLD
    ]
    least = results.value(
        "least_off", "smallest difference in a newer release", extreme(min, newer)
    )
    most = results.value(
        "most_off", "largest difference in a newer release", extreme(max, newer)
    )
    cured = results.value(
        "cured_off",
        "largest absolute difference in the oldest release or with another setting",
        largest_size(cell for cell in right if cell.value is not None),
    )
    settings = {
        name: results.chosen(name, f"given: {words}", number, unit)
        for name, words, number, unit in (
            ("mass", "mass of the box", 10.0, "g"),
            ("inertia", "inertia of the turntable [kg m²]", 1000.0, PLAIN),
            ("impratio", "impratio", 100.0, PLAIN),
            ("tolerance", "strict tolerance", 1e-10, PLAIN),
        )
    }
    claim = Claim(
        "fast_in_newer",
        all_of(
            at_least(least, 5.0, "clearly different"),
            at_most(cured, 1.0, "the same rate"),
        ),
        {"least": least, "most": most, "cured": cured, "old": OLD, **settings},
    )
    columns = {words: rates[name] for name, words in SETTINGS.items()}
    table = table_of("MuJoCo C", releases, columns, tolerance=settings["tolerance"])
    return Section(tables={"rates": table}, claims=[claim])

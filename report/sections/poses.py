"""The runs that are shown moving: what they come to."""

from measured_report.parts.section import Section
from measured_report.values.results import Results
from report.shared.tables import by_case

order = 125
page = "fix"
label = "see it move"
labels = {
    "as-shipped": "shipped pads",
    "as-shipped-10cm": "shipped pads, 10 cm",
    "stiff-pads-10cm": "stiff pads, 10 cm",
    "hold-#s": "arm held still, {} s",
}

COLUMNS = {
    "amplitude": "shake_amplitude_m",
    "time": "shake_duration_s",
    "slip at the end": "slip_mm",
    "out of the grasp after": "left_grasp_s",
    "cube ends at": "cube_height_m",
}


def derive(results: Results) -> Section:
    return Section(tables={"runs": by_case(results.rows, COLUMNS)})

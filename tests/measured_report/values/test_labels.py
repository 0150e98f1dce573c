"""What people call a case: the first of its section's labels that fits, with its numbers as one reads them."""

import pytest

from measured_report.values.labels import label_of

LABELS = {"as-shipped": "shipped pads", "ke-#-1": "ke {}, 1 step", "ke-#-#": "ke {}, {} steps", "kd-#-#": "kd {1}"}


@pytest.mark.parametrize(
    ("case", "label"),
    [
        ("as-shipped", "shipped pads"),
        ("as-shipped-10cm", "as shipped 10cm"),
        ("ke-4.64e+04-1", "ke 46400, 1 step"),
        ("ke-2.5e6-16", "ke 2.5×10⁶, 16 steps"),
        ("ke-1e-10-0.2", "ke 10⁻¹⁰, 0.2 steps"),
        ("kd-100-8e3", "kd 8000"),
        ("has_no-label", "has no label"),
    ],
)
def test_a_case_is_called_by_the_first_label_that_fits_or_by_its_own_name(case, label):
    assert label_of(case, LABELS) == label

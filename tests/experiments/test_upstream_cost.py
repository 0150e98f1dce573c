"""What the patch for MuJoCo Warp costs: the patched package runs apart, and no other release is patched."""

import pytest

from experiments.simulation.measurement import Conditions
from experiments.upstream_cost import measure_apart, measure_released
from measured_report.editions.devices import is_about
from measured_report.records.provenance import package_versions

ON_CPU = Conditions(device="cpu", quick=True)
HAS_RELEASE = is_about("upstream_cost", package_versions())


@pytest.mark.skipif(HAS_RELEASE, reason="the patch is for this release")
def test_another_release_is_not_patched_where_its_lines_are_only_alike():
    with pytest.raises(RuntimeError, match="patch failed"):
        measure_apart(ON_CPU, "", 1)


@pytest.mark.slow
@pytest.mark.skipif(not HAS_RELEASE, reason="the patch is for another release")
def test_off_a_frame_has_the_kernels_of_the_released_package_and_on_one_more_a_step_that_acts():
    mjcf, released = measure_released(ON_CPU)
    off, on = measure_apart(ON_CPU, mjcf, 1)
    assert off["kernel_count"] == released["kernel_count"] == on["kernel_count"] - on["substeps"]
    assert on["asked_change_m_s2"] > 1e-3 and on["frame_ratio"] > 0.0

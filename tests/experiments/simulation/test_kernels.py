"""Test kernels that are compiled before they are launched."""

from itertools import chain

import warp as wp
from toys import program

from experiments.simulation.kernels import launched_kernels, scene_kernels


@wp.kernel(module="unique")
def doubled(values: wp.array(dtype=float)):
    i = wp.tid()
    values[i] = 2.0 * values[i]


def test_what_would_be_launched_is_known_and_not_launched():
    """Test that an error while kernels are listed has no effect on the values, because
    no kernel was launched.
    """
    values = wp.array([1.0], dtype=float, device="cpu")

    def run():
        wp.launch(doubled, 1, [values], device="cpu")
        raise IndexError

    assert launched_kernels(wp.get_device("cpu"), run) == {
        (doubled.module, 1): [doubled]
    }
    assert not doubled.module.execs and values.numpy()[0] == 1.0
    wp.launch(doubled, 1, [values], device="cpu")
    assert values.numpy()[0] == 2.0


def test_all_that_a_frame_launches_is_known_without_a_launch_with_the_types_that_it_is_launched_with():
    """Test that all kernels of a frame are known with their types, so that they can be
    compiled at once and only once.
    """
    launched = [*chain(*scene_kernels("cpu").values())]
    assert "end_frame" in {kernel.key for kernel in launched}
    generic = [kernel for kernel in launched if kernel.is_generic]
    assert generic and all(kernel.overloads for kernel in generic)


LOOK = """
import warp as wp
from experiments.simulation.kernels import has_begun, is_bare
print(is_bare(), has_begun())
wp.init()
print(has_begun(), wp.config.kernel_cache_dir)
"""


def test_whether_a_machine_is_bare_is_known_before_warp_begins_which_then_keeps_its_kernels_where_it_would(
    tmp_path,
):
    """Test that an empty cache is detected before Warp starts, so that forked processes
    can compile the kernels.
    """
    lines = program("-c", LOOK, WARP_CACHE_PATH=str(tmp_path)).stdout.splitlines()
    assert (lines[0], lines[-1]) == (
        "True False",
        f"True {tmp_path / wp.config.version}",
    )

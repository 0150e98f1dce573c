"""The shake test on the simulator: the scene, its batched runs and what is recorded of them."""

"""Engines, a file each, and one way to run a scene on them.

``scene.py`` has scenes and traces as data. ``run(scene, engine)`` returns the trace of a
scene: that of ``mjcf`` in MuJoCo C, in MuJoCo Warp and through Newton, in this process;
that of ``newton_solver`` in any of Newton's solvers; and that of ``engine`` in engines
with environments of their own, which run several scenes at a time. ``grasp`` makes
columns of what a shake shows, in whatever engine.
"""

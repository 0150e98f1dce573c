"""Run a scene on different engines; each engine has a separate file.

``scene.py`` defines scenes and traces as data. ``run(scene, engine)`` returns the trace
of a scene. ``mjcf`` runs scenes in this process, in MuJoCo C, in MuJoCo Warp and
through Newton. ``newton_solver`` runs them in any of Newton's solvers. ``engine`` runs
several scenes at a time in engines that need separate environments. ``grasp`` computes
columns of a shake for any engine.
"""

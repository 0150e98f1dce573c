"""List public advice on slipping grasps, its sources, and the runs that follow it."""

from report.story.trials import Advice, Source, Symptom, Trial

NEWTON = "https://github.com/newton-physics/newton/blob/v1.5.0/{}"
GUIDE = NEWTON.format("docs/concepts/simulation_tuning{}.rst")
MUJOCO = "https://mujoco.readthedocs.io/en/stable/{}"
ISAAC = "https://isaac-sim.github.io/IsaacLab/{}.html"
ISSUE = "https://github.com/{}"
SOURCES = {
    "guide": Source(
        "Newton, Simulation Tuning",
        "1.5.0",
        GUIDE.format(""),
    ),
    "contacts": Source(
        "Newton, MuJoCo-Warp Contact Tuning",
        "1.5.0",
        GUIDE.format("_mujoco"),
    ),
    "knobs": Source(
        "Newton, Solver Tuning Reference",
        "1.5.0",
        GUIDE.format("_solvers"),
    ),
    "newton_changes": Source(
        "Newton, changelog",
        "1.5.0",
        NEWTON.format("CHANGELOG.md"),
    ),
    "porting": Source(
        "Isaac Lab, Solver Comparison",
        "develop",
        ISAAC.format(
            "develop/source/overview/core-concepts/physical-backends/solver-comparison"
        ),
    ),
    "tune_warp": Source(
        "Isaac Lab, Tune MJWarp",
        "3.0.0",
        ISAAC.format("release/3.0.0/source/concepts/solver-tuning/tune_mjwarp"),
    ),
    "slip": Source(
        "MuJoCo, Preventing slip",
        "3.12.0",
        MUJOCO.format("modeling.html#preventing-slip"),
    ),
    "soft": Source(
        "MuJoCo, Softness and slip",
        "3.12.0",
        MUJOCO.format("overview.html#softness-and-slip"),
    ),
    "solver": Source(
        "MuJoCo, Solver settings",
        "3.12.0",
        MUJOCO.format("modeling.html#solver-settings"),
    ),
    "solref": Source(
        "MuJoCo, Solver parameters",
        "3.12.0",
        MUJOCO.format("modeling.html#solver-parameters"),
    ),
    "integration": Source(
        "MuJoCo, Numerical integration",
        "3.12.0",
        MUJOCO.format("computation/index.html#numerical-integration"),
    ),
    "investigation": Source(
        "the investigation",
        "Newton 1.4.0",
        "https://reports.eric-heiden.com/grasp-shake-drift",
    ),
    "capsule": Source(
        "mujoco#3328",
        "MuJoCo 3.8.1",
        ISSUE.format("google-deepmind/mujoco/issues/3328"),
    ),
    "flat": Source(
        "mujoco#698",
        "January 2023",
        ISSUE.format("google-deepmind/mujoco/issues/698"),
    ),
    "robotiq": Source(
        "mujoco#786",
        "December 2023",
        ISSUE.format("google-deepmind/mujoco/issues/786"),
    ),
    "claw": Source(
        "innate-os#730",
        "August 2026",
        ISSUE.format("innate-inc/innate-os/pull/730"),
    ),
    "pinch": Source(
        "newton#4003",
        "Newton 1.5.0",
        ISSUE.format("newton-physics/newton/issues/4003"),
    ),
}

SHIPPED = "newton-elliptic/shipped/substeps-{}"
STIFF = "newton-elliptic/stiff/substeps-{}"
CURE = "{}-shipped-3cm-plain-rounded"
EULER = "newton-euler-50"
FAST = "newton-implicitfast-50"
SOFT = "pad-ke-2.5e3"
HARD = "pad-ke-2.5e5"
SLIPS, DROPS, JITTERS, SINKS, EXPLODES = Symptom


def _steps(where: str, pads: str, of: int, to: int, column: str = "slip_mm") -> Trial:
    runs = (pads.format(of), pads.format(to))
    return Trial("time_step", *runs, where, column, "substep_ms")


def _pinch(
    before: str,
    after: str,
    setting: str = "",
    engine: str = "c",
    where: str = "in the still pinch",
) -> Trial:
    runs = (f"{before}-{engine}", f"{after}-{engine}")
    names = ("pyramidal", "elliptic")
    return Trial("scenes", *runs, where, "creep_mm_s", setting, names)


def _held(
    before: str, after: str, where: str, setting: str, column: str = "creep_mm_s"
) -> Trial:
    return Trial("stability", before, after, where, column, setting)


def _cured(before: str, after: str, *names: str) -> Trial:
    runs = (CURE.format(before), CURE.format(after))
    before_name, after_name = names
    return Trial("cure", *runs, names=(before_name, after_name))


def _noslip(engine: str, where: str) -> Trial:
    run = f"as-shipped-{engine}"
    return Trial(
        "solver", run, f"{run}-noslip", where, names=("without NoSlip", "with NoSlip")
    )


def _solver(name: str) -> Trial:
    names = ("MuJoCo Warp", name)
    run = f"{name.lower()}-3cm"
    return Trial("newton_solvers", "warp-3cm", run, f"with {name}", names=names)


def _hydroelastic(shape: str = "", where: str = "in the shake") -> Trial:
    names = ("contact points", "hydroelastic")
    runs = (f"points{shape}", f"area{shape}")
    return Trial("hydroelastic", *runs, where, names=names)


def _sunk(pads: str, of: int, to: int, where: str) -> Trial:
    runs = (f"steps-{pads}-{of}", f"steps-{pads}-{to}")
    return _held(*runs, where, "step_ms", "penetration_mm")


ADVICE = (
    Advice(
        "raise_mu",
        SLIPS,
        "Raise the friction coefficient before you touch the stiffness",
        "contacts",
        (Trial("friction", "pad-mu-1", "pad-mu-10"),),
    ),
    Advice(
        "port_mu",
        SLIPS,
        "Expect to raise friction coefficients after porting from PhysX",
        "porting",
        (Trial("friction", "pad-mu-1", "pad-mu-3"),),
    ),
    Advice(
        "stiffen",
        SLIPS,
        "Raise ke and kd if friction is adequate but the grasp deflects",
        "contacts",
        (
            Trial("stiffness", SOFT, HARD, "with ke and kd raised"),
            Trial("stiffness", SOFT, "pad-ke-2.5e5-kd-100", "with only ke raised"),
            Trial(
                "upgrade",
                "as-shipped-mujoco-contacts",
                "stiff-pads-mujoco-contacts",
                "with MuJoCo’s contacts",
                names=("shipped pads", "stiff pads"),
            ),
        ),
        "speed/stiff-pads-only",
    ),
    Advice(
        "fix_of_investigation",
        SLIPS,
        "Raise the pads’ ke and kd, and reduce the cube’s gap",
        "investigation",
        (Trial("fix", "as-shipped", "fixed"),),
        "speed/stiff-pads-only",
    ),
    Advice(
        "elliptic",
        SLIPS,
        "Prefer an elliptic friction cone",
        "contacts",
        (
            Trial("solver", "cone-pyramidal", "iterations-15"),
            _pinch("pyramidal", "recipe"),
        ),
    ),
    Advice(
        "port_cone",
        SLIPS,
        "Consider an elliptic cone after porting from PhysX",
        "porting",
        (Trial("solver", "cone-pyramidal", "iterations-15"),),
    ),
    Advice(
        "impratio",
        SLIPS,
        "Raise impratio",
        "slip",
        (
            Trial("solver", "iterations-15", "impratio-1000", setting="impratio"),
            _pinch("recipe", "impratio-1000", "impratio"),
        ),
        "error_runtime/as-shipped/newton/impratio-1000",
    ),
    Advice(
        "impratio_needs_ellipse",
        SLIPS,
        "Use a high impratio only with elliptic cones",
        "robotiq",
        (
            _cured(
                "pyramidal-implicitfast-400",
                "newton-implicitfast-400",
                "pyramidal",
                "elliptic",
            ),
        ),
    ),
    Advice(
        "recipe_for_claw",
        SLIPS,
        "Use an elliptic cone with an impratio above its default",
        "claw",
        (
            Trial(
                "lab",
                "impratio-1",
                "as-shipped",
                "in the shake in MuJoCo C",
                setting="impratio",
                names=("", "shipped impratio"),
            ),
            _pinch("impratio-1", "recipe", "impratio"),
        ),
    ),
    Advice(
        "noslip",
        SLIPS,
        "Enable the NoSlip solver",
        "slip",
        (
            _noslip("mujoco-c", "in the shake in MuJoCo C"),
            _noslip("warp", "in the shake in MuJoCo Warp"),
            _pinch("recipe", "noslip", "noslip_iterations"),
        ),
    ),
    Advice(
        "noslip_for_capsule",
        SLIPS,
        "Enable NoSlip for an object that creeps in a still grip",
        "capsule",
        (
            _pinch("recipe", "noslip", "noslip_iterations", "c", "in MuJoCo C"),
            _pinch("recipe", "noslip", "noslip_iterations", "warp", "in MuJoCo Warp"),
            _pinch(
                "recipe", "noslip", "noslip_iterations", "newton", "in Newton from MJCF"
            ),
        ),
    ),
    Advice(
        "tolerance",
        SLIPS,
        "Use Newton’s method with a very small tolerance",
        "solver",
        (Trial("solver", "iterations-15", "tolerance-1e-10"),),
    ),
    Advice(
        "iterations",
        SLIPS,
        "Raise the iterations of the solver",
        "guide",
        (Trial("solver", "iterations-15", "iterations-200"),),
        "error_runtime/as-shipped/newton/iterations-200",
    ),
    Advice(
        "impedance",
        SLIPS,
        "Increase the impedance, which is part of solimp",
        "soft",
        (Trial("stiffness", SOFT, "solimp-dmax-0.9999"),),
    ),
    Advice(
        "time_constant",
        SLIPS,
        "Adjust solref; here its time constant is shorter",
        "soft",
        (
            Trial("lab", "as-shipped", "stiff-pads", "in the shake in MuJoCo C"),
            _pinch("recipe", "stiff", "timeconst_s"),
        ),
    ),
    Advice(
        "smaller_step",
        SLIPS,
        "Reduce the time step before you raise the stiffness",
        "guide",
        (
            _steps("with shipped pads", SHIPPED, 16, 64),
            _steps("with stiff pads of constant ke and kd", STIFF, 16, 64),
        ),
        "step_cost/stiff/substeps-64",
    ),
    Advice(
        "more_substeps",
        SLIPS,
        "Take more substeps after porting from PhysX",
        "porting",
        (_steps("with shipped pads", SHIPPED, 1, 4),),
    ),
    Advice(
        "richer_geometry",
        SLIPS,
        "Use richer contact geometry",
        "guide",
        (Trial("contact_source", "contacts-60hz", "pads-convex-mesh"),),
    ),
    Advice(
        "fresh_contacts",
        SLIPS,
        "Find contacts in every substep while the grasp is weak",
        "knobs",
        (Trial("contact_source", "contacts-60hz", "contacts-960hz"),),
        "error_runtime/as-shipped/newton-each-substep/substeps-16",
    ),
    Advice(
        "mujoco_contacts",
        SLIPS,
        "Begin with MuJoCo’s own contacts as the simplest baseline",
        "tune_warp",
        (Trial("contact_source", "contacts-60hz", "contacts-mujoco"),),
        "error_runtime/as-shipped/mujoco/substeps-16",
    ),
    Advice(
        "gaps",
        SLIPS,
        "Check that contact gaps suit the scale of the scene",
        "knobs",
        (Trial("gap", "cube-gap-default", "all-gaps-zero"),),
        "speed/all-gaps-zero",
    ),
    Advice(
        "condim",
        SLIPS,
        "Raise condim if torsional friction is too low",
        "slip",
        (_pinch("recipe", "condim-6", "condim"),),
    ),
    Advice(
        "friction_gain",
        SLIPS,
        "Set kf, which gives friction its own time constant",
        "newton_changes",
        (
            Trial(
                "upgrade",
                "as-shipped-kf-off",
                "as-shipped",
                names=("kf below zero", "shipped kf"),
            ),
        ),
    ),
    Advice(
        "other_solver",
        SLIPS,
        "Use a solver that supports the constraints that you need",
        "guide",
        (_solver("Kamino"), _solver("XPBD"), _solver("Steel")),
    ),
    Advice(
        "implicitfast",
        SLIPS,
        "Use implicitfast, the recommended integrator",
        "integration",
        (_cured(EULER, FAST, "Euler", "implicitfast"),),
    ),
    Advice(
        "runge_kutta",
        SLIPS,
        "Use RK4, which is more accurate if energy is conserved",
        "integration",
        (_cured(FAST, "newton-rk4-50", "implicitfast", "RK4"),),
        "error_runtime/as-shipped/newton-rk4/substeps-16",
    ),
    Advice(
        "grip_force",
        DROPS,
        "Check the gripping force first",
        "contacts",
        (
            _held("grip-0.5", "grip-2", "with a weak grip", "grip_ratio"),
            _held("grip-1.2", "grip-4", "with a firm grip", "grip_ratio"),
        ),
    ),
    Advice(
        "friction_too_low",
        DROPS,
        "Increase a sliding friction coefficient that is too low",
        "slip",
        (
            _held("friction-0.001", "friction-1", "with slippery pads", "pad_mu"),
            _held("friction-1", "friction-100", "with rough pads", "pad_mu"),
        ),
    ),
    Advice(
        "buffers",
        DROPS,
        "Enlarge nconmax and njmax if contacts disappear",
        "tune_warp",
        (_held("buffers-contact-4", "buffers-ample", "in the shake", "contact_max"),),
    ),
    Advice(
        "hydroelastic",
        DROPS,
        "Use hydroelastic contacts if the quality of the patch matters",
        "guide",
        (
            _hydroelastic(),
            _hydroelastic("/plate", "with a thin plate"),
            _hydroelastic("/edge", "with the cube gripped at two edges"),
        ),
    ),
    Advice(
        "hydroelastic_pinch",
        DROPS,
        "Stay with Newton 1.3, because 1.5 drops a hydroelastic pinch that 1.3 holds",
        "pinch",
    ),
    Advice("multiccd", DROPS, "Enable multiccd", "flat"),
    Advice(
        "step_against_jitter",
        JITTERS,
        "Reduce the time step",
        "slip",
        (
            _steps("with shipped pads", SHIPPED, 4, 16, "oscillation_mm"),
            _steps("with stiff pads", STIFF, 4, 16, "oscillation_mm"),
        ),
        "step_cost/stiff/substeps-16",
    ),
    Advice("armature", JITTERS, "Add armature to the joints", "slip"),
    Advice("lower_restitution", JITTERS, "Reduce the restitution", "porting"),
    Advice(
        "penetration",
        SINKS,
        "Raise ke, and kd with it",
        "contacts",
        (Trial("stiffness", SOFT, HARD, column="penetration_mm"),),
        "speed/stiff-pads-only",
    ),
    Advice(
        "plateau",
        SINKS,
        "Raise dmax, the plateau of the impedance",
        "contacts",
        (Trial("stiffness", SOFT, "solimp-dmax-0.9999", column="penetration_mm"),),
    ),
    Advice(
        "step_against_penetration",
        SINKS,
        "Reduce the time step first",
        "guide",
        (
            _sunk("as-shipped", 16, 64, "with shipped pads"),
            _sunk("stiff", 4, 16, "with stiff pads"),
        ),
    ),
    Advice(
        "raise_damping",
        EXPLODES,
        "Keep ke and raise kd toward critical damping",
        "contacts",
        (
            _held(
                "ke-kd-100-1e+05-4", "ke-critical-1e+05-4", "with a long step", "pad_kd"
            ),
            _held(
                "ke-kd-100-1e+05-64",
                "ke-critical-1e+05-64",
                "with a short step",
                "pad_kd",
            ),
        ),
    ),
    Advice(
        "lower_stiffness",
        EXPLODES,
        "Lower the contact stiffness",
        "guide",
        (
            _held(
                "ke-kd-100-2.15e+06-16",
                "ke-kd-100-1e+05-16",
                "if ke is too high for kd",
                "pad_ke",
            ),
        ),
    ),
    Advice(
        "step_against_explosion",
        EXPLODES,
        "Reduce the time step",
        "contacts",
        (
            _held(
                "ke-kd-100-2.15e+06-8",
                "ke-kd-100-2.15e+06-64",
                "if ke is too high for kd",
                "step_ms",
            ),
        ),
    ),
    Advice(
        "two_steps",
        EXPLODES,
        "Keep the time constant of solref at two steps or more",
        "solref",
        (
            _held(
                "clamp-direct-1",
                "clamp-direct-2",
                "with a direct solref",
                "timeconst_steps",
            ),
        ),
    ),
    Advice(
        "overlap",
        EXPLODES,
        "Avoid shapes that overlap at the start",
        "contacts",
        (
            _held(
                "overlap-pads-as-shipped-5mm",
                "overlap-pads-as-shipped-0.1mm",
                "with shipped pads",
                "overlap_mm",
            ),
        ),
    ),
)

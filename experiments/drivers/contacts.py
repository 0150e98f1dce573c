"""Summarize the contacts of a world and predict the creep from them."""

from dataclasses import dataclass

import mujoco
import numpy as np

import contact_bias_c
from newton_lint.law import Contact, Option, impedance_at, response_of


@dataclass(frozen=True)
class Contacts:
    """Sums over the contacts of a world that carry force."""

    count: int
    normal_n: float  # sum of the normal forces [N]
    # R of the friction rows combined into one row, 1 / Σ 1/R [1/kg]; 0 without contacts
    softness_1_kg: float
    # b of the rows [1/s], the smallest if they differ; 0 without contacts
    damping_per_s: float
    depth_m: float  # mean depth [m]

    @classmethod
    def of(
        cls,
        model: mujoco.MjModel,
        rows,
        friction,
        solref,
        solimp,
        dist,
        force,
        stiffness,
    ) -> "Contacts":
        """Return the sums over contacts.

        The contacts are given by their first rows, parameters and distances, and by the
        force and D (1 / R) of all rows.
        """
        loaded = [
            index for index, row in enumerate(rows) if row >= 0 and force[row] > 0.0
        ]
        if not loaded:
            return cls(0, 0.0, 0.0, 0.0, 0.0)
        if model.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC:
            stiff = [stiffness[rows[index] + 1] for index in loaded]
            normal = [force[rows[index]] for index in loaded]
        else:
            # Opposite edges pull with mu (f - f') and receive mu times the sliding
            # velocity. With condim 3 there are two pairs of edges.
            stiff = [
                2.0 * friction[index][0] ** 2 * stiffness[rows[index]]
                for index in loaded
            ]
            normal = [np.sum(force[rows[index] : rows[index] + 4]) for index in loaded]
        damping = min(
            contact_bias_c.damping(model, solref[index], solimp[index])
            for index in loaded
        )
        depth = -np.mean([dist[index] for index in loaded])
        return cls(
            len(loaded),
            float(np.sum(normal)),
            float(1.0 / np.sum(stiff)),
            float(damping),
            float(depth),
        )

    def creep_m_s(self, load_n: float) -> float:
        """Return the predicted creep of a held body under a constant load [m/s].

        The prediction follows from R f = b v for each row.
        """
        return load_n * self.softness_1_kg / self.damping_per_s


def forecast_creep_m_s(
    contacts: Contacts, load_n: float, contact: Contact, option: Option
) -> float:
    """Return the same prediction from contact parameters and the mean depth [m/s]."""
    impedance = impedance_at(contact.solimp, contacts.depth_m)
    response = response_of(contact, option, impedance)
    return response.load_m_s_n * load_n / contacts.count


def load_columns(
    contacts: Contacts, load_n: float, contact: Contact, option: Option
) -> dict[str, float]:
    """Return both predictions of the creep under a load, and its contacts."""
    predicted_m_s = 0.0 if option.noslip else contacts.creep_m_s(load_n)
    forecast_m_s = forecast_creep_m_s(contacts, load_n, contact, option)
    return {
        "predicted_creep_mm_s": 1e3 * predicted_m_s,
        "forecast_creep_mm_s": 1e3 * forecast_m_s,
        "normal_force_n": contacts.normal_n,
        "loaded_contact_count": contacts.count,
    }

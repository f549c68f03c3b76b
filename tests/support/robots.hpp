// Mechanisms with masses, made in code.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mechanism/mechanism.hpp"

namespace abstand::testing {

/// A revolute or prismatic frame about `axis` (parent's axes at the value 0), `xyz` from its parent.
mechanism::MechanismFrame jointFrame(int id, int parent, mechanism::JointType type, const Vector3d& axis,
                                     const Vector3d& xyz, int dof);

/// A point mass (kg) at `com_F`.
mechanism::LinkInertia pointMass(double mass, const Vector3d& com_F);

/// A solid box of uniform density, of the given mass and edges (m), its centre at `com_F`.
mechanism::LinkInertia boxMass(double mass, const Vector3d& size, const Vector3d& com_F);

/// One point mass at the end of a rod of length l that turns about y and hangs along -z at q = 0.
mechanism::Mechanism pendulum(double mass, double length);

/// Two point masses at the ends of two rods in a row, as above; q1 is the angle between the rods.
mechanism::Mechanism doublePendulum(double m0, double l0, double m1, double l1);

/// A tree of revolute, prismatic and fixed frames about any axis with masses, offsets and scales, drawn from
/// the seed; with `mimic`, some joints share a dof.
mechanism::Mechanism randomRobot(std::uint64_t seed, int frames, bool mimic);

/// Seven revolute joints, 1.3 m, 16 kg, limits and efforts like those of light arms; our own figures.
mechanism::Mechanism sevenAxisArm();

/// 47 degrees of freedom: wheeled base (3), torso (3), head (2), two arms (7 each) with four fingers (3 each)
/// and one palm (0.5 each: one more dof on the left hand).
mechanism::Mechanism humanoid();

/// Uniform in [-reach, reach].
std::vector<double> randomValues(int n, std::uint64_t seed, std::uint64_t stream, double reach);

}  // namespace abstand::testing

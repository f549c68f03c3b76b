// abstand dynamics: joint efforts of postures and motions, mass matrix, effective mass.
#include <algorithm>
#include <cmath>

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"
#include "app/cli/mesh_argument.hpp"
#include "app/cli/robot_texts.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "core/mechanism/effective_mass.hpp"
#include "core/mechanism/forward_dynamics.hpp"
#include "core/mechanism/link_inertia.hpp"
#include "core/mechanism/smooth_motion.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "core/robot_file/robot.hpp"

namespace abstand::cli {
namespace {

constexpr std::size_t kMaxRows = 10'000'000;  // of --out

struct DynamicsArguments {
  std::string mechanism, q, qd, qdd, gravity, motion, out;
  double rate{1000.0};
  std::vector<std::string> solids, wrenches, effective;
  robot_file::PackagePaths packages;
};

int frameNamed(const mechanism::Mechanism& mechanism, const std::string& name, const std::string& option) {
  for (std::size_t i = 0; i < mechanism.frames.size(); ++i)
    if (mechanism.frames[i].name == name) return static_cast<int>(i);
  throw UsageError(option + ": the mechanism has no frame '" + name + "'");
}

/// FRAME:n,n,...
std::pair<int, std::vector<double>> frameAndNumbers(const mechanism::Mechanism& mechanism,
                                                    const std::string& text, const std::string& option,
                                                    std::size_t count, const std::string& form) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) throw UsageError(option + ": found '" + text + "', expected " + form);
  const auto v = numberList(text.substr(colon + 1), option);
  if (v.size() != count)
    throw UsageError(option + ": found " + std::to_string(v.size()) + " numbers, expected " +
                     std::to_string(count));
  return {frameNamed(mechanism, text.substr(0, colon), option), v};
}

/// Parses FRAME:MESH:DENSITY and adds a solid of that density (kg/m^3) to the frame's mass.
void addSolid(mechanism::Mechanism& mechanism, const std::string& text,
              const robot_file::PackagePaths& packages) {
  const std::size_t first = text.find(':'), last = text.rfind(':');
  if (first == std::string::npos || first == last)
    throw UsageError("--solid: found '" + text + "', expected FRAME:MESH:DENSITY");
  const int frame = frameNamed(mechanism, text.substr(0, first), "--solid");
  const std::string file = text.substr(first + 1, last - first - 1);
  const double density = number(text.substr(last + 1), "--solid " + text);
  if (!(density > 0.0))
    throw UsageError("--solid: found a density of " + text.substr(last + 1) +
                     ", expected more than 0 kg/m^3");
  const geometry::MassProperties solid =
      geometry::massProperties(mesh_file::loadMesh(meshArgument(file, packages)).mesh);
  if (solid.volume <= 0.0)
    throw ParseError({file}, "found a mesh without volume, expected a closed surface for a density");
  auto& inertia = mechanism.frames[static_cast<std::size_t>(frame)].inertia;
  inertia = mechanism::together(inertia, mechanism::inertiaOfSolid(solid, density, Transform::Identity()));
}

std::vector<double> jointNumbers(const std::string& text, const std::string& option, int dof) {
  std::vector<double> v(static_cast<std::size_t>(dof), 0.0);
  if (!text.empty()) v = numberList(text, option);
  if (v.size() != static_cast<std::size_t>(dof))
    throw UsageError(option + ": found " + std::to_string(v.size()) + " values, expected " +
                     std::to_string(dof));
  return v;
}

mechanism::Mechanism robotWithMasses(const DynamicsArguments& args) {
  mechanism::Mechanism mechanism = robot_file::loadRobot(args.mechanism).mechanism;
  for (const auto& text : args.solids) addSolid(mechanism, text, args.packages);
  double mass = 0.0;
  for (const auto& f : mechanism.frames) {
    const std::string fault = mechanism::inertiaFault(f.inertia);
    if (!fault.empty()) throw ParseError({args.mechanism}, "frame '" + f.name + "': " + fault);
    mass += f.inertia.mass;
  }
  if (mass == 0.0)
    throw ParseError({args.mechanism}, "found no frame with a mass, expected at least one",
                     "--solid FRAME:MESH:DENSITY gives a frame the mass of a mesh");
  return mechanism;
}

nlohmann::ordered_json massJson(const Eigen::MatrixXd& M) {
  auto rows = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < M.rows(); ++i)
    rows.push_back(std::vector<double>(M.row(i).begin(), M.row(i).end()));
  return rows;
}

nlohmann::ordered_json linksJson(const mechanism::Mechanism& mechanism, std::string& text) {
  auto links = nlohmann::ordered_json::array();
  double sum = 0.0;
  for (const auto& f : mechanism.frames) {
    if (f.inertia.mass == 0.0) continue;
    links.push_back({{"frame", f.name},
                     {"mass", f.inertia.mass},
                     {"com", toJson(f.inertia.com_F)},
                     {"inertia", toJson(f.inertia.inertia_F)}});
    text += format("link %s: %.4g kg\n", f.name.c_str(), f.inertia.mass);
    sum += f.inertia.mass;
  }
  text += format("total %.4g kg\n", sum);
  return links;
}

/// Efforts along a motion: peak values, and all rows to --out.
nlohmann::ordered_json alongMotion(const DynamicsArguments& args, const mechanism::Mechanism& mechanism,
                                   const mechanism::RigidTree& tree, const Vector3d& gravity_B,
                                   mechanism::JointLimitWatch& watch, std::string& text) {
  const mechanism::SmoothMotion motion(mechanism::loadMotion(args.motion, mechanism.dof));
  const auto n = static_cast<std::size_t>(mechanism.dof);
  const double rows = std::floor((motion.end() - motion.start()) * args.rate + 1e-9) + 1.0;
  if (!(rows <= static_cast<double>(kMaxRows)))
    throw UsageError("--rate: found " + formatDouble(args.rate) + " Hz, which makes more than " +
                     std::to_string(kMaxRows) + " rows");
  std::unique_ptr<OutputFile> out;
  if (!args.out.empty()) {
    out = std::make_unique<OutputFile>(args.out);
    out->stream() << "t";
    for (const char* name : {"q", "qd", "qdd", "effort"})
      for (std::size_t k = 0; k < n; ++k) out->stream() << "," << name << k;
    out->stream() << "\n";
  }
  mechanism::TreeState state;
  std::vector<double> q(n), qd(n), qdd(n), efforts(n), peak(n, 0.0), peak_t(n, motion.start());
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
    const double t = motion.start() + static_cast<double>(row) / args.rate;
    motion.at(t, q, qd, qdd);
    mechanism::inverseDynamics(tree, {q, qd, qdd}, {gravity_B, {}}, state, efforts);
    watch.check(t, q, qd, qdd, efforts);
    for (std::size_t k = 0; k < n; ++k) {
      if (std::abs(efforts[k]) <= peak[k]) continue;
      peak[k] = std::abs(efforts[k]);
      peak_t[k] = t;
    }
    if (!out) continue;
    out->stream() << formatDouble(t);
    for (const auto* v : {&q, &qd, &qdd, &efforts})
      for (const double x : *v) out->stream() << "," << formatDouble(x);
    out->stream() << "\n";
  }
  if (out) out->commit();

  auto peaks = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < n; ++k) {
    // Of mimic joints the first has the motor.
    const auto b = std::find_if(tree.bodies.begin(), tree.bodies.end(), [&](const mechanism::TreeBody& body) {
      return static_cast<std::size_t>(body.dof) == k;
    });
    if (b == tree.bodies.end()) continue;
    const auto& f = mechanism.frames[static_cast<std::size_t>(b->frame)];
    const double limit = std::abs(b->scale) * f.limits.effort;
    peaks.push_back({{"dof", k}, {"frame", f.name}, {"effort", peak[k]}, {"t", peak_t[k]}});
    peaks.back()["limit"] = numberOrNull(limit);
    peaks.back()["within_limit"] = peak[k] <= limit;
    text += format("dof %zu: maximum %.6g at %.6g s%s\n", k, peak[k], peak_t[k],
                   peak[k] <= limit ? "" : format(", exceeds its limit of %.6g", limit).c_str());
  }
  return peaks;
}

int runDynamics(const CommandLine& line, const DynamicsArguments& args) {
  const mechanism::Mechanism mechanism = robotWithMasses(args);
  const mechanism::RigidTree tree = mechanism::makeRigidTree(mechanism);
  const int dof = mechanism.dof;
  const auto q = jointNumbers(args.q, "--q", dof), qd = jointNumbers(args.qd, "--qd", dof),
             qdd = jointNumbers(args.qdd, "--qdd", dof);
  Vector3d gravity_B = mechanism::kGravity;
  if (!args.gravity.empty()) {
    const auto v = numberList(args.gravity, "--gravity");
    if (v.size() != 3) throw UsageError("--gravity: found " + args.gravity + ", expected x,y,z in m/s^2");
    gravity_B = Vector3d(v[0], v[1], v[2]);
  }

  mechanism::ForwardState state;
  mechanism::placeBodies(tree, q, state.tree);
  std::vector<Wrench> external(tree.bodies.size());
  for (const auto& text : args.wrenches) {
    const auto [frame, v] = frameAndNumbers(mechanism, text, "--wrench", 6, "FRAME:fx,fy,fz,tx,ty,tz");
    const int body = tree.frames[static_cast<std::size_t>(frame)].body;
    if (body < 0) continue;
    const Wrench w{Vector3d(v[0], v[1], v[2]), Vector3d(v[3], v[4], v[5])};
    external[static_cast<std::size_t>(body)] +=
        mechanism::aboutOrigin(w, mechanism::poseOfFrame(tree, state.tree, frame).translation());
  }

  std::string text = format("%s: %d degrees of freedom\n", args.mechanism.c_str(), dof);
  nlohmann::ordered_json document{{"dof", dof}};
  document["links"] = linksJson(mechanism, text);
  std::vector<double> efforts(q.size()), gravity(q.size()), bias(q.size());
  mechanism::gravityEfforts(tree, q, gravity_B, state.tree, gravity);
  mechanism::biasEfforts(tree, q, qd, gravity_B, state.tree, bias);
  mechanism::inverseDynamics(tree, {q, qd, qdd}, {gravity_B, external}, state.tree, efforts);
  mechanism::massMatrix(tree, state.tree, state.mass);
  for (std::size_t k = 0; k < q.size(); ++k)
    text += format("dof %zu: effort %.6g, including gravity %.6g\n", k, efforts[k], gravity[k]);
  document["efforts"] = efforts;
  document["gravity_efforts"] = gravity;
  document["bias_efforts"] = bias;
  document["mass_matrix"] = massJson(state.mass.M);
  mechanism::TreeState energy_state;
  const mechanism::MechanicalEnergy energy =
      mechanism::mechanicalEnergy(tree, q, qd, gravity_B, energy_state);
  document["kinetic_energy"] = energy.kinetic;
  document["potential_energy"] = energy.potential;

  if (!args.effective.empty()) {
    if (const int massless = mechanism::factor(state.mass); massless >= 0)
      throw ParseError({args.mechanism}, "dof " + std::to_string(massless) +
                                             " has no mass to move, expected a mass at or beyond each joint");
    auto rows = nlohmann::ordered_json::array();
    std::vector<double> work(q.size());
    for (const auto& option : args.effective) {
      const auto [frame, v] = frameAndNumbers(mechanism, option, "--effective", 3, "FRAME:nx,ny,nz");
      const Vector3d n_B = Vector3d(v[0], v[1], v[2]).normalized();
      if (!(n_B.norm() > 0.5)) throw UsageError("--effective: found no direction in '" + option + "'");
      const double mass =
          mechanism::effectiveMass({tree, state.tree, state.mass}, frame,
                                   mechanism::poseOfFrame(tree, state.tree, frame).translation(), n_B, work);
      const auto& name = mechanism.frames[static_cast<std::size_t>(frame)].name;
      rows.push_back({{"frame", name}, {"direction", toJson(n_B)}});
      rows.back()["mass"] = numberOrNull(mass);
      text +=
          format("frame %s along %.3f %.3f %.3f: ", name.c_str(), n_B.x(), n_B.y(), n_B.z()) +
          (std::isfinite(mass) ? format("%.6g kg\n", mass) : "infinite, no joint moves in this direction\n");
    }
    document["effective_masses"] = rows;
  }
  mechanism::JointLimitWatch watch(mechanism::dofLimits(mechanism));
  if (args.motion.empty())
    watch.check(kNaN, q, qd, qdd, efforts);
  else
    document["peaks"] = alongMotion(args, mechanism, tree, gravity_B, watch, text);
  const auto limits = run::reportsOf("", mechanism, watch.breaches(), true);
  document["joint_limits"] = jointLimitsJson(limits);
  text += jointLimitsText(limits);
  line.print(document, text);
  return kDone;
}

}  // namespace

void addDynamics(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "dynamics", "joint efforts that postures and motions need",
                 "abstand dynamics data/robots/lwr/lwr4.mech --q 0,0.5,0,-1.2,0,0.8,0 --effective "
                 "7:0,0,1");
  auto args = std::make_shared<DynamicsArguments>();
  command->add_option("MECHANISM", args->mechanism, "mechanism file (.mech or .urdf)")->required();
  command->add_option("--q", args->q, "joint values a,b,... in SI (default: zeros)");
  command->add_option("--qd", args->qd, "joint velocities (default: zeros)");
  command->add_option("--qdd", args->qdd, "joint accelerations (default: zeros)");
  command->add_option("--gravity", args->gravity, "x,y,z in m/s^2, axes of the base (default: 0,0,-9.80665)");
  command->add_option("--solid", args->solids,
                      "FRAME:MESH:DENSITY adds the mass of a mesh, in the frame's axes, of kg/m^3");
  command->add_option("--wrench", args->wrenches,
                      "FRAME:fx,fy,fz,tx,ty,tz in the base's axes, acting at that frame's origin");
  command->add_option("--effective", args->effective,
                      "FRAME:nx,ny,nz: effective mass at that frame's origin in this direction");
  command->add_option("--motion", args->motion, "CSV t,q0,q1,...: efforts along it, as a smooth motion");
  command->add_option("--rate", args->rate, "samples per second of the motion (default: 1000)")
      ->check(CLI::Range(0.001, 1e6));
  line.output(command->add_option("--out", args->out, "CSV of the motion with its efforts"));
  addPackagePath(command, args->packages);
  command->callback([&line, args] { line.run = [&line, args] { return runDynamics(line, *args); }; });
}

}  // namespace abstand::cli

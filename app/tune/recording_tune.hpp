// Runs one recording through a scene to collect margin data.
#pragma once

#include "app/run/run_scene.hpp"
#include "app/tune/distance_pass.hpp"
#include "core/margin/margin_outcome.hpp"
#include "humanmodel/enclosed_share.hpp"

namespace abstand::tune {

struct TuneOptions {
  PassOptions pass;
  double restart_time{0.0};  ///< s, MarginOptions::restart_time
  /// Names of the options that the user stated, with any value, sorted: "limit", "separation.intrusion"...
  /// What is missing is a default that nobody has confirmed.
  std::vector<std::string> stated;

  margin::MarginOptions margins() const { return {pass.limit, restart_time}; }
};

/// One person of a run, for reports.
struct PersonNote {
  std::string name,
      text;  ///< "operator"; "1.750 m, 81.6 kg, mean of both sexes; clothing: none; tools: none"
};

/// A file that a run depends on.
struct InputFile {
  std::string name, content;  ///< its name with that of its folder; content hash (XXH3)
  bool operator==(const InputFile&) const = default;
};

/// A term of the protective distance with its source.
struct CitedTerm {
  std::string key, source,
      to_be_checked;  ///< of SeparationOptions; edition and table; why to check it, or empty
  double value{0.0};  ///< SI, as the table states it
  bool operator==(const CitedTerm&) const = default;
};

/// Data of one recording for all later questions.
struct TunedRecording {
  std::string recording;                   ///< file, or the scene's name if people follow its recordings
  std::filesystem::path file;              ///< its result file; empty if none was written
  std::shared_ptr<const void> file_owner;  ///< removes a temporary `file` at the end; null for others
  std::string content;                     ///< content hash of the recording's file; empty if there is none
  std::size_t frames{0};
  double t0{0.0}, t1{0.0};  ///< s, first and last frame
  double unjudged{0.0};     ///< s at the beginning, see firstJudgedFrame(); the longest of all parts
  /// Without the lists of the parts' frames if `file` has them: PartFrames reads them.
  PassResult pass;
  std::string contact_limits;                  ///< ContactLimits::stamp(); empty: contacts were not judged
  std::vector<contact::RegionLimits> regions;  ///< of the predicted contacts (stored_limits.hpp)
  std::string separation_edition;              ///< SeparationStandard::edition; empty: no table was used
  std::string separation_table;                ///< SeparationStandard::stamp(); empty: no table was used
  std::vector<CitedTerm> separation_terms;     ///< of that table
  std::vector<std::string> clamped;            ///< PassOptions::clamped, with the parts that the scene names
  std::vector<InputFile> files;  ///< scene, robots, motions, meshes, recordings, in the order of the scene
  std::vector<PersonNote> people;
  /// For each of pass.parts: share of people whose part the model encloses, bare; of several people in the
  /// scene the smallest.
  std::vector<humanmodel::EnclosedShare> enclosed;
  std::vector<run::Reservation> reservations;
  /// Warm starts of the pass; empty: every frame was a cold start.
  std::optional<run::RunSummary::WarmStart> warm_start;
  bool interrupted{false};

  double seconds() const { return t1 - t0; }
};

/// Runs the session over its frames in lock step, without reactions. `run`: provides progress and interrupt
/// callbacks. Throws UsageError.
TunedRecording tuneRecording(session::Session& session, const TuneOptions& options,
                             const run::RunOptions& run, const std::string& name);

}  // namespace abstand::tune

// Live Kinect v1 through libfreenect: the only file that includes the library.
#include "tracking/depth/live/freenect_camera.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/text/message_text.hpp"
#include "tracking/depth/formats/freenect_depth.hpp"

namespace abstand::tracking {

KinectChoice kinectOf(const std::string& name) {
  constexpr std::size_t kLongestSerial = 31;
  const std::string first = kKinectSource;
  const auto isPlain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  };
  if (name == first) return {};
  const std::string rest = name.starts_with(first + ":") ? name.substr(first.size() + 1) : "";
  if (rest.size() == 1 && rest[0] >= '1' && rest[0] <= '9') return {rest[0] - '0', {}};
  if (rest.size() > 1 && rest.size() <= kLongestSerial && std::all_of(rest.begin(), rest.end(), isPlain))
    return {1, rest};
  throw UsageError("found the camera " + text::inQuotes(name) +
                   ", expected live:kinect, live:kinect:2 (the second), or live:kinect:SERIAL");
}

}  // namespace abstand::tracking

#ifdef ABSTAND_FREENECT

#include <dlfcn.h>
#include <libfreenect.h>
#include <sys/time.h>

#include <cstring>
#include <vector>

namespace abstand::tracking {
namespace {

constexpr const char* kLibrary = "libfreenect.so.0.5";
constexpr long kWait = 100000;  // us

/// Functions used of the library, with the types of its header.
struct Library {
  decltype(&freenect_init) init;
  decltype(&freenect_shutdown) shutdown;
  decltype(&freenect_set_log_level) setLogLevel;
  decltype(&freenect_set_log_callback) setLogCallback;
  decltype(&freenect_process_events_timeout) processEvents;
  decltype(&freenect_num_devices) countDevices;
  decltype(&freenect_select_subdevices) selectSubdevices;
  decltype(&freenect_open_device) openDevice;
  decltype(&freenect_open_device_by_camera_serial) openSerial;
  decltype(&freenect_close_device) closeDevice;
  decltype(&freenect_set_user) setUser;
  decltype(&freenect_get_user) getUser;
  decltype(&freenect_set_depth_callback) setDepthCallback;
  decltype(&freenect_find_depth_mode) findDepthMode;
  decltype(&freenect_set_depth_mode) setDepthMode;
  decltype(&freenect_start_depth) startDepth;
  decltype(&freenect_stop_depth) stopDepth;
  bool knows_millimetres{false};  ///< from the device's calibration
};

/// Loads the library once and keeps it until the program ends: its threads may outlive a camera.
Library load(const std::string& camera) {
  void* const handle = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr)
    throw ParseError({camera},
                     "found no loadable library (" + std::string(::dlerror()) + "), expected " + kLibrary,
                     "Debian's package libfreenect0.5 has it");
  const auto find = [&](auto& function, const char* name) {
    void* const found = ::dlsym(handle, name);
    if (found == nullptr)
      throw ParseError({camera}, std::string("found a ") + kLibrary + " without " + name +
                                     ", expected that of libfreenect 0.5");
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(found);
  };
  Library lib{};
  find(lib.init, "freenect_init");
  find(lib.shutdown, "freenect_shutdown");
  find(lib.setLogLevel, "freenect_set_log_level");
  find(lib.setLogCallback, "freenect_set_log_callback");
  find(lib.processEvents, "freenect_process_events_timeout");
  find(lib.countDevices, "freenect_num_devices");
  find(lib.selectSubdevices, "freenect_select_subdevices");
  find(lib.openDevice, "freenect_open_device");
  find(lib.openSerial, "freenect_open_device_by_camera_serial");
  find(lib.closeDevice, "freenect_close_device");
  find(lib.setUser, "freenect_set_user");
  find(lib.getUser, "freenect_get_user");
  find(lib.setDepthCallback, "freenect_set_depth_callback");
  find(lib.findDepthMode, "freenect_find_depth_mode");
  find(lib.setDepthMode, "freenect_set_depth_mode");
  find(lib.startDepth, "freenect_start_depth");
  find(lib.stopDepth, "freenect_stop_depth");
  // fakenect lacks both this and the millimetre mode, and ends a program that requests the latter.
  lib.knows_millimetres = ::dlsym(handle, "freenect_copy_registration") != nullptr;
  return lib;
}

/// `camera`: the name of the one to be opened, for errors.
const Library& library(const std::string& camera = kKinectSource) {
  static const Library loaded = load(camera);
  return loaded;
}

// Messages of the library have no context; they arrive on the thread that called it.
thread_local std::string last_error;

void keepError(freenect_context*, freenect_loglevel, const char* message) {
  last_error = message;
  while (!last_error.empty() && last_error.back() == '\n') last_error.pop_back();
}

std::string why() { return last_error.empty() ? "" : " (" + last_error + ")"; }

}  // namespace

struct FreenectCamera::Device {
  OnImage on_image;
  /// fakenect delivers values at an odd address, so they are copied.
  std::vector<std::uint16_t> numbers = std::vector<std::uint16_t>(std::size_t{kKinectWidth} * kKinectHeight);
  freenect_context* context{nullptr};
  freenect_device* device{nullptr};
  bool raw{true};
  std::string error;

  ~Device() {
    if (device != nullptr) {
      library().stopDepth(device);
      library().closeDevice(device);
    }
    if (context != nullptr) library().shutdown(context);
  }
};

FreenectCamera::FreenectCamera(const std::string& name, OnImage on_image)
    : device_(std::make_unique<Device>()) {
  const KinectChoice choice = kinectOf(name);
  const Library& lib = library(name);
  Device& d = *device_;
  d.on_image = std::move(on_image);
  last_error.clear();
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    return ParseError({name}, "found " + found + why() + ", expected " + expected);
  };
  if (lib.init(&d.context, nullptr) < 0) {
    d.context = nullptr;
    throw refuse("no USB access for libfreenect", "a machine with a Kinect v1 at a USB port");
  }
  lib.setLogLevel(d.context, FREENECT_LOG_ERROR);
  lib.setLogCallback(d.context, keepError);
  lib.selectSubdevices(d.context, FREENECT_DEVICE_CAMERA);
  const int count = lib.countDevices(d.context);
  if (count < 1) throw refuse("no camera", "a Kinect v1 at a USB port, with its power supply");
  if (choice.serial.empty() && count < choice.place)
    throw refuse(std::to_string(count) + (count == 1 ? " Kinect" : " Kinects"),
                 std::to_string(choice.place) + ", each at a USB controller of its own");
  const int opened = choice.serial.empty() ? lib.openDevice(d.context, &d.device, choice.place - 1)
                                           : lib.openSerial(d.context, &d.device, choice.serial.c_str());
  if (opened < 0) {
    d.device = nullptr;
    const std::string expected =
        "one not in use by another program, and access rights (on Debian: group plugdev)";
    if (choice.serial.empty()) throw refuse("a Kinect that cannot be opened", expected);
    throw refuse("no Kinect with this serial number that can be opened", expected);
  }
  d.raw = !lib.knows_millimetres;
  const freenect_frame_mode mode =
      lib.findDepthMode(FREENECT_RESOLUTION_MEDIUM, d.raw ? FREENECT_DEPTH_11BIT : FREENECT_DEPTH_MM);
  if (mode.is_valid == 0 || mode.width != kKinectWidth || mode.height != kKinectHeight)
    throw refuse("a Kinect without 640 x 480 depths", "a Kinect v1");
  lib.setUser(d.device, &d);
  lib.setDepthCallback(d.device, [](freenect_device* device, void* bytes, std::uint32_t) {
    Device& to = *static_cast<Device*>(library().getUser(device));
    std::memcpy(to.numbers.data(), bytes, to.numbers.size() * sizeof(std::uint16_t));
    to.on_image(to.numbers.data());
  });
  if (lib.setDepthMode(d.device, mode) < 0 || lib.startDepth(d.device) < 0)
    throw refuse("a Kinect without a depth stream", "one that starts");
}

FreenectCamera::~FreenectCamera() = default;

bool FreenectCamera::isRaw() const { return device_->raw; }

bool FreenectCamera::serve() {
  timeval wait{0, kWait};
  last_error.clear();
  const bool is_there = library().processEvents(device_->context, &wait) >= 0;
  if (!last_error.empty()) device_->error = last_error;
  return is_there;
}

std::string FreenectCamera::lastError() const { return device_->error; }

}  // namespace abstand::tracking

#else

namespace abstand::tracking {

struct FreenectCamera::Device {};

FreenectCamera::FreenectCamera(const std::string& name, OnImage) {
  kinectOf(name);
  throw ParseError({name}, "found a program that was built without libfreenect.h, expected one with it",
                   "Debian's package libfreenect-dev has it; configure and build again");
}
FreenectCamera::~FreenectCamera() = default;
bool FreenectCamera::isRaw() const { return true; }
bool FreenectCamera::serve() { return false; }
std::string FreenectCamera::lastError() const { return {}; }

}  // namespace abstand::tracking

#endif

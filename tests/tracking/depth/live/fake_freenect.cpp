// A libfreenect without hardware, for what fakenect cannot play: no camera, no right to it, several cameras,
// a camera that goes or falls silent. The environment variable FAKE_KINECT has, with commas, the role of each
// camera, whose serial numbers are KINECT1, KINECT2, ...:
//   no_usb | no_camera | locked | silent
//   mm:N           N images, of which number i is full of 700 + i, then the camera is gone
//   still:N        N such images, then it is silent
//   play:FOLDER    a recording of `record` at its own rate, then the camera is gone
#include <libfreenect.h>
#include <libfreenect_registration.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr std::size_t kPixels = std::size_t{640} * 480;
constexpr auto kStep = std::chrono::milliseconds(5);

std::vector<std::string> roles() {
  const char* const text = std::getenv("FAKE_KINECT");
  std::istringstream all(text ? text : "no_camera");
  std::vector<std::string> roles;
  for (std::string role; std::getline(all, role, ',');) roles.push_back(role);
  return roles;
}

}  // namespace

struct _freenect_device {
  std::string role;
  void* user{nullptr};
  freenect_depth_cb on_depth{nullptr};
  std::size_t sent{0};
  std::vector<std::string> files;  ///< of a recording
  std::chrono::steady_clock::time_point begin;
};
struct _freenect_context {
  freenect_log_cb log{nullptr};
  std::unique_ptr<_freenect_device> device;
};

namespace {

void complain(freenect_context* context, const char* message) {
  if (context->log != nullptr) context->log(context, FREENECT_LOG_ERROR, message);
}

std::string folderOf(const _freenect_device& device) { return device.role.substr(5); }

int gone(freenect_context* context) {
  complain(context, "USB camera marked dead, stopping streams\n");
  return -1;
}

/// s, of the name of an image in INDEX.txt: d-TIME-NUMBER.pgm.
double timeOf(const std::string& file) { return std::atof(file.c_str() + 2); }

/// The 11-bit disparities of a dump as millimetres, by the formula that the project uses for disparities.
std::vector<std::uint16_t> millimetres(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string word;
  for (int i = 0; i < 4; ++i) in >> word;  // P5, width, height, largest value
  in.get();
  std::vector<std::uint16_t> numbers(kPixels);
  in.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(2 * kPixels));
  for (std::uint16_t& n : numbers) {
    const double z = n < 2047 ? 1000.0 / (3.3309495161 - 0.0030711016 * n) : 0.0;
    n = z > 0.0 && z < 10000.0 ? static_cast<std::uint16_t>(z) : std::uint16_t{0};
  }
  return numbers;
}

int play(freenect_context* context) {
  _freenect_device& device = *context->device;
  if (device.sent == device.files.size()) return gone(context);
  const std::string& file = device.files[device.sent];
  const std::chrono::duration<double> after(timeOf(file) - timeOf(device.files.front()));
  std::this_thread::sleep_until(device.begin +
                                std::chrono::duration_cast<std::chrono::steady_clock::duration>(after));
  std::vector<std::uint16_t> image = millimetres(folderOf(device) + "/" + file);
  ++device.sent;
  device.on_depth(&device, image.data(), 0);
  return 0;
}

}  // namespace

extern "C" {

int freenect_init(freenect_context** context, freenect_usb_context*) {
  if (roles().front() == "no_usb") return -1;
  *context = new _freenect_context;
  return 0;
}
int freenect_shutdown(freenect_context* context) {
  delete context;
  return 0;
}
void freenect_set_log_level(freenect_context*, freenect_loglevel) {}
void freenect_set_log_callback(freenect_context* context, freenect_log_cb log) { context->log = log; }
int freenect_num_devices(freenect_context*) {
  return roles().front() == "no_camera" ? 0 : static_cast<int>(roles().size());
}
void freenect_select_subdevices(freenect_context*, freenect_device_flags) {}
int freenect_open_device(freenect_context* context, freenect_device** device, int index) {
  const std::string role = roles().at(static_cast<std::size_t>(index));
  if (role == "locked") {
    complain(context, "Could not open camera: LIBUSB_ERROR_ACCESS\n");
    return -3;
  }
  context->device = std::make_unique<_freenect_device>();
  *device = context->device.get();
  context->device->role = role;
  if (role.rfind("play:", 0) == 0) {
    std::ifstream index_file(folderOf(**device) + "/INDEX.txt");
    for (std::string file; index_file >> file;) context->device->files.push_back(file);
  }
  return 0;
}
int freenect_open_device_by_camera_serial(freenect_context* context, freenect_device** device,
                                          const char* serial) {
  for (std::size_t i = 0; i < roles().size(); ++i)
    if ("KINECT" + std::to_string(i + 1) == serial)
      return freenect_open_device(context, device, static_cast<int>(i));
  return -1;
}
int freenect_close_device(freenect_device*) { return 0; }
void freenect_set_user(freenect_device* device, void* user) { device->user = user; }
void* freenect_get_user(freenect_device* device) { return device->user; }
void freenect_set_depth_callback(freenect_device* device, freenect_depth_cb call) { device->on_depth = call; }
freenect_frame_mode freenect_find_depth_mode(freenect_resolution resolution, freenect_depth_format form) {
  freenect_frame_mode mode;
  std::memset(&mode, 0, sizeof mode);
  mode.resolution = resolution;
  mode.depth_format = form;
  mode.width = 640;
  mode.height = 480;
  mode.is_valid = form == FREENECT_DEPTH_MM ? 1 : 0;
  return mode;
}
int freenect_set_depth_mode(freenect_device*, const freenect_frame_mode) { return 0; }
int freenect_start_depth(freenect_device* device) {
  device->begin = std::chrono::steady_clock::now();
  return 0;
}
int freenect_stop_depth(freenect_device*) { return 0; }
/// Its being there says that the library knows millimetres.
freenect_registration freenect_copy_registration(freenect_device*) { return {}; }

int freenect_process_events_timeout(freenect_context* context, timeval*) {
  _freenect_device& device = *context->device;
  if (device.role.rfind("play:", 0) == 0) return play(context);
  std::this_thread::sleep_for(kStep);
  if (device.role == "silent") return 0;
  const std::size_t colon = device.role.find(':');
  if (device.sent == static_cast<std::size_t>(std::atoi(device.role.c_str() + colon + 1)))
    return device.role.rfind("still:", 0) == 0 ? 0 : gone(context);
  std::vector<std::uint16_t> image(kPixels, static_cast<std::uint16_t>(700 + device.sent));
  image[0] = 0;
  image[1] = 65535;
  ++device.sent;
  device.on_depth(&device, image.data(), 0);
  return 0;
}

}  // extern "C"

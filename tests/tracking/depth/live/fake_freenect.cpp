// A libfreenect without hardware, for what fakenect cannot play: no camera, no right to it, a camera that
// goes or falls silent. What it does is said by the environment variable FAKE_KINECT:
//   no_usb | no_camera | locked | silent | mm:N (N images, of which number i is
//   full of 700 + i, then the camera is gone)
#include <libfreenect.h>
#include <libfreenect_registration.h>

#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

struct _freenect_context {
  freenect_log_cb log{nullptr};
};
struct _freenect_device {
  void* user{nullptr};
  freenect_depth_cb on_depth{nullptr};
};

namespace {

_freenect_context the_context;
_freenect_device the_device;
int sent = 0;

std::string role() {
  const char* const text = std::getenv("FAKE_KINECT");
  return text ? text : "no_camera";
}

void complain(const char* message) {
  if (the_context.log != nullptr) the_context.log(&the_context, FREENECT_LOG_ERROR, message);
}

}  // namespace

extern "C" {

int freenect_init(freenect_context** context, freenect_usb_context*) {
  if (role() == "no_usb") return -1;
  *context = &the_context;
  the_context.log = nullptr;
  sent = 0;
  return 0;
}
int freenect_shutdown(freenect_context*) { return 0; }
void freenect_set_log_level(freenect_context*, freenect_loglevel) {}
void freenect_set_log_callback(freenect_context* context, freenect_log_cb log) { context->log = log; }
int freenect_num_devices(freenect_context*) { return role() == "no_camera" ? 0 : 1; }
void freenect_select_subdevices(freenect_context*, freenect_device_flags) {}
int freenect_open_device(freenect_context*, freenect_device** device, int) {
  if (role() == "locked") {
    complain("Could not open camera: LIBUSB_ERROR_ACCESS\n");
    return -3;
  }
  *device = &the_device;
  return 0;
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
int freenect_start_depth(freenect_device*) { return 0; }
int freenect_stop_depth(freenect_device*) { return 0; }
/// Its being there says that the library knows millimetres.
freenect_registration freenect_copy_registration(freenect_device*) { return {}; }

int freenect_process_events_timeout(freenect_context*, timeval*) {
  const timespec pause{0, 5000000};
  ::nanosleep(&pause, nullptr);
  if (role() == "silent") return 0;
  if (sent == std::atoi(role().substr(3).c_str())) {
    complain("USB camera marked dead, stopping streams\n");
    return -1;
  }
  std::vector<std::uint16_t> image(640 * 480, static_cast<std::uint16_t>(700 + sent));
  image[0] = 0;
  image[1] = 65535;
  ++sent;
  the_device.on_depth(&the_device, image.data(), 0);
  return 0;
}

}  // extern "C"

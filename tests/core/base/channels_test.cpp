#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/base/spsc_ring.hpp"
#include "core/base/triple_buffer.hpp"

namespace abstand {
namespace channels_test {

struct Twin {
  long a{0}, b{0};
};

TEST(TripleBuffer, ReaderNeverSeesPartialValue) {
  TripleBuffer<Twin> buffer;
  std::atomic<bool> done{false};
  std::jthread writer([&] {
    for (long i = 1; i <= 100000; ++i) {
      buffer.back() = {i, -i};
      buffer.publish();
    }
    done = true;
  });
  long last = 0;
  while (!done || buffer.fresh()) {
    const Twin& t = buffer.latest();
    ASSERT_EQ(t.a, -t.b);
    ASSERT_GE(t.a, last);
    last = t.a;
  }
  EXPECT_EQ(buffer.latest().a, 100000);
}

TEST(SpscRing, KeepsOrderAndCountsEverySample) {
  SpscRing<long, 64> ring;
  long lost = 0;
  std::atomic<bool> done{false};
  std::jthread writer([&] {
    for (long i = 0; i < 50000; ++i) lost += ring.push(i) ? 0 : 1;
    done = true;
  });
  std::vector<long> out;
  while (!done) ring.drainInto(out);
  ring.drainInto(out);
  writer.join();
  EXPECT_EQ(static_cast<long>(out.size()) + lost, 50000);
  for (std::size_t i = 1; i < out.size(); ++i) ASSERT_LT(out[i - 1], out[i]);
}

}  // namespace channels_test
}  // namespace abstand

// The ledger of flakes after billions of them, in a window of its own.
#include "step05_collision/ledger.hpp"

#include <gtest/gtest.h>

#include "common/bindings.glsl"
#include "common/program.hpp"
#include "tests/common/harness/small_window.hpp"

TEST(Ledger, CountsOnWhereAWordIsFull)
{
    const Harness window{small_window(4.3)};
    const Ledger ledger;
    ledger.bind();
    // Each number stands some counts before the end of its low word, or of its third.
    const uint64_t word = 1ull << 32;
    const uint64_t before[4] = {word - 1, word - 64, 3 * word - 500, word - 1000};
    GLint buffer = 0;
    glGetIntegeri_v(GL_ATOMIC_COUNTER_BUFFER_BINDING, LEDGER_BUFFER, &buffer);
    glBindBuffer(GL_ATOMIC_COUNTER_BUFFER, GLuint(buffer));
    glBufferSubData(GL_ATOMIC_COUNTER_BUFFER, 0, sizeof before, before);

    const Program program({{GL_COMPUTE_SHADER, "tests/step05_collision/count.comp"}});
    program.use();
    glDispatchCompute(10, 1, 1);  // 640 flakes

    testing::internal::CaptureStdout();
    ledger.print({});
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
              "ledger: released " + std::to_string(before[0] + 640) +
                  " = airborne 0 + lying 0 + deposited " + std::to_string(before[1] + 640) +
                  " + melted " + std::to_string(before[2] + 640) + " + left " +
                  std::to_string(before[3] + 640) + "\n");
}

// Hosts that trap floats (Delphi, some engines) get no exception: every scenario runs with traps on invalid, infinite and too large results.
#include "tests/scenarios.h"
#include "tests/winds.h"

#include <cfenv>

// Clang divides in lanes that are not used.
#if defined(__GLIBC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <csignal>
#include <cstring>
#include <unistd.h>

namespace {

using namespace windrow;
using namespace windrow::test;

char row_name[256];

void say_and_end(int) {
    for (const char* const part : {"a trap in the scenario ", static_cast<const char*>(row_name), "\n"})
        if (write(STDERR_FILENO, part, std::strlen(part)) < 0)
            break;
    _exit(1);
}

class Traps {
  public:
    Traps() : before_(std::signal(SIGFPE, say_and_end)) {
        std::feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    }
    ~Traps() {
        fedisableexcept(FE_ALL_EXCEPT);
        (void)std::signal(SIGFPE, before_);
    }
    Traps(const Traps&) = delete;
    Traps& operator=(const Traps&) = delete;

  private:
    void (*before_)(int);
};

TEST(FloatTraps, NoScenarioSpringsOne) {
    std::vector<Scenario> rows = scenarios(true);
    for (Scenario& row : random_scenarios(8))
        rows.push_back(std::move(row));
    for (const Simd level : {Simd::baseline, Simd::avx2, Simd::avx512})
        for (const Scenario& row : rows) {
            std::strncpy(row_name, row.name.c_str(), sizeof row_name - 1);
            Config config = scenario_config();
            if (row.config)
                row.config(config);
            config.simd = level;
            auto wind = Wind::create(config);
            if (!wind)
                break; // not on this processor
            const Traps traps;
            if (row.begin)
                row.begin(*wind);
            for (int n = 0; n < 3; ++n) {
                if (row.step)
                    row.step(*wind, n);
                (void)wind->step(k_scenario_step);
            }
            for (const double y : {1.0, -30.0, 100.0})
                (void)wind->velocity({0.3, y, 0.2});
            std::vector<float> pressure(wind->box().cell_count());
            ASSERT_TRUE(wind->write_pressure(pressure));
            const auto bytes = wind->save();
            ASSERT_TRUE(bytes);
            ASSERT_TRUE(Wind::load(*bytes));
            (void)wind->advance(0.05);
        }
}

} // namespace

#endif

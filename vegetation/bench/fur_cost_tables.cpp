// What coats cost: the thesis' scenes, layers, orders, shadows, lamps, strands outside of the body.
#include "vegetation/bench/fur_scenes.h"
#include "vegetation/bench/fur_tables.h"

#include <cmath>
#include <cstdio>

namespace windrow::vegetation::bench {

void scenes_table(const FurRun& run) {
    std::vector<FurCase> cases;
    cases.push_back(thesis_scene("naive, 256 layers", 256));
    cases.front().coats.front().settings.levels.one_draw_each = true;
    for (const int layers : {256, 24, 14})
        cases.push_back(thesis_scene("instanced, " + std::to_string(layers), layers));
    cases.push_back(thesis_light_scene("24, lamp, shadow, plane", 24));
    cases.push_back(thesis_many_scene("18 spheres and plane, 24", 24));
    cases.push_back(beast_scene("beast that walks, 24", 24));
    const Measured of =
        measured(run, "The thesis' scenes", "coats as theirs (fur_scenes.h), march 0, inner layers first; wind 16 x 16 x 16",
                 std::move(cases));
    print_times(of, 2);
    print_counts(of);
    const struct {
        const char* what;
        std::size_t row, over;
        const char* theirs;
        const char* factor;
    } rows[] = {{"naive / instanced, 256 layers each", 0, 1, "none of theirs", "256.48"},
                {"naive 256 / instanced 24", 0, 2, "0.86 / 0.58 = 1.48", "256.48"},
                {"24 with lamp, shadow, plane / 24", 4, 2, "0.60 / 0.58 = 1.03", "11.07"},
                {"18 spheres and plane / 24", 5, 2, "6.36 / 0.58 = 10.97", "4.74"},
                {"18 spheres and plane / 24 with lamp, shadow, plane", 5, 4, "6.36 / 0.60 = 10.60", "4.74"},
                {"animal / 24", 6, 2, "0.80 / 0.58 = 1.38", "6.63"}};
    std::printf("\n| | ours | theirs | factor, ours | with shadows | theirs, as they state it |\n|---|---|---|---|---|---|\n");
    for (const auto& row : rows) {
        const CoatCosts& cost = of.costs[row.row];
        const auto vertices = static_cast<double>(of.stages[row.row]->vertices());
        const auto ran = static_cast<double>(cost.colour.invocations);
        const auto shadows = static_cast<double>(cost.shadow[0].invocations + cost.shadow[1].invocations);
        std::printf("| %s | %.2f | %s | %.2f | %.2f | %s |\n", row.what, ratio(*of.stages[row.row], *of.stages[row.over]),
                    row.theirs, ran / vertices, (ran + shadows) / vertices, row.factor);
    }
}

void layers_table(const FurRun& run) {
    constexpr int k_layers[] = {8, 16, 32, 64, 128, 256};
    std::vector<FurCase> cases;
    for (const int layers : k_layers) {
        cases.push_back(fur_scene("N = " + std::to_string(layers), layers));
        cases.back().coats.front().settings.levels.skip_empty = false;
    }
    const Measured of =
        measured(run, "Against the number of layers", "fur on the sphere of 515 vertices, march 4, no shadow", std::move(cases));
    print_times(of);
    print_counts(of);
    // Least squares of y = a + b N.
    const auto fit = [&](const char* what, const char* unit, auto&& value) {
        double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
        for (std::size_t row = 0; row < of.stages.size(); ++row) {
            const double layers = k_layers[row], v = value(row);
            n += 1.0, x += layers, y += v, xx += layers * layers, xy += layers * v, yy += v * v;
        }
        const double slope = (n * xy - x * y) / (n * xx - x * x), start = (y - slope * x) / n;
        const double r = (n * xy - x * y) / std::sqrt((n * xx - x * x) * (n * yy - y * y));
        std::printf("%s = %.4g + %.4g N %s, R^2 = %.6f\n\n", what, start, slope, unit, r * r);
    };
    std::printf("\n");
    // The same pixels for all rows: those of the most layers.
    const auto pixels = static_cast<double>(of.costs.back().pixels);
    fit("fragments a pixel", "", [&](std::size_t row) { return static_cast<double>(of.costs[row].colour.fragments) / pixels; });
    fit("written samples a pixel", "", [&](std::size_t row) { return static_cast<double>(of.costs[row].written) / pixels; });
    fit("colour pass", "ms", [&](std::size_t row) { return of.stages[row]->median("colour"); });
}

void order_table(const FurRun& run) {
    std::vector<FurCase> cases;
    const auto add = [&](const char* name, int march, bool outer, bool depth) {
        cases.push_back(fur_scene(name, 32));
        fur::CoatLevels& levels = cases.back().coats.front().settings.levels;
        levels.march = march;
        levels.outer_first = outer;
        levels.depth_first = depth;
    };
    add("outer first, march 4", 4, true, false);
    add("inner first, march 4", 4, false, false);
    add("depth pass, outer first, march 4", 4, true, true);
    add("depth pass, inner first, march 4", 4, false, true);
    add("outer first, march 0", 0, true, false);
    add("inner first, march 0", 0, false, false);
    add("depth pass, outer first, march 0", 0, true, true);
    add("outer first, march 2", 2, true, false);
    add("outer first, march 8", 8, true, false);
    const Measured of = measured(run, "Order, depth pass, march", "fur of 32 layers on the sphere", std::move(cases));
    print_times(of);
    print_counts(of);
}

void shadow_table(const FurRun& run) {
    std::vector<FurCase> cases;
    const auto add = [&](const char* name, int layers, bool strands) {
        cases.push_back(fur_scene(name, 40));
        cases.back().coats.push_back(floor(4.0f, -0.65));
        cases.back().from = {0.0, 1.0, 3.0};
        fur::CoatLevels& levels = cases.back().coats.front().settings.levels;
        levels.shadow_shells = layers;
        levels.shadow_strands = strands;
    };
    add("no shadow", 0, true);
    add("the body's", 1, false);
    add("of 16 layers", 16, true);
    add("of 40 layers", 40, true);
    const Measured of =
        measured(run, "Shadow", "fur of 40 layers on the sphere over a plane; two maps of 512 x 512", std::move(cases));
    print_times(of);
    print_counts(of);
    std::printf("\nOf 40 layers on / off: %.3f; theirs (Bloodelic, a laptop): 80 for 90 frames a second, 12.5 / 11.1 ms = 1.125 "
                "(+1.39 ms)\n",
                ratio(*of.stages[3], *of.stages[0]));
}

void lamps_table(const FurRun& run) {
    std::vector<FurCase> cases;
    for (const int lamps : {0, 1, 2, 8}) {
        cases.push_back(fur_scene(std::to_string(lamps) + (lamps == 1 ? " lamp" : " lamps"), 32));
        for (int n = 0; n < lamps; ++n) {
            const double turn = 6.283185307 * n / 8.0;
            cases.back().lamps.push_back(
                {.position = {1.6 * std::cos(turn), 0.5, 1.6 * std::sin(turn)}, .colour = glm::vec3(4.0f, 2.0f, 1.0f)});
        }
    }
    print_times(measured(run, "Lamps", "fur of 32 layers on the sphere, no shadow", std::move(cases)));
}

void body_table(const FurRun& run) {
    std::vector<FurCase> cases;
    for (const bool avoids : {false, true}) {
        cases.push_back(beast_scene(avoids ? "the same, outside of its body" : "beast that walks", 32));
        cases.back().coats.front().settings.avoids_body = avoids;
    }
    for (const bool avoids : {false, true}) {
        cases.push_back(fur_scene(avoids ? "the same, which has no hollow" : "sphere", 32));
        cases.back().coats.front().settings.avoids_body = avoids;
    }
    const Measured of = measured(run, "Strands outside of the body", "fur of 32 layers", std::move(cases));
    print_times(of);
    std::printf("\n| | least of the prepare stage | over the row before |\n|---|---|---|\n");
    for (std::size_t n = 1; n < of.stages.size(); n += 2)
        std::printf("| %s | %.2f | %.2f |\n", of.stages[n]->wanted().name.c_str(), of.stages[n]->least("prepare"),
                    of.stages[n]->least("prepare") / of.stages[n - 1]->least("prepare"));
}

} // namespace windrow::vegetation::bench

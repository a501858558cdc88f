#include "cli/pareto/pareto_panel.h"

#include "cli/drawing/palette.h"
#include "cli/pareto/label_places.h"
#include "cli/pareto/log_axis.h"
#include "cli/pareto/method_style.h"
#include "fluid/message.h"
#include "scene/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace windrow::cli {
namespace {

using detail::message;

constexpr double k_worst_drawn = 3.0; // an error of 300 % is no flow any more; what is above stands on the upper edge
constexpr double k_label_size = 13.0, k_tick_size = 13.0;
constexpr double k_marker = 3.6, k_front_marker = 5.6, k_ring = 9.5;

std::string time_text(double ms) {
    return ms >= 1000.0 ? scene::figure(ms / 1000.0) + " s" : scene::figure(ms) + " ms";
}

std::string share_text(double error) {
    return scene::figure(std::round(error * 1e9) / 1e7) + " %";
}

// Ends of an axis around the values, `before` and `after` as factors.
LogAxis axis_around(const std::vector<double>& values, double before, double after, double from, double to) {
    LogAxis axis{.from = from, .to = to};
    if (values.empty())
        return axis;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    axis.low = *least / before;
    axis.high = *most * after;
    return axis;
}

/// A panel while it is drawn.
class Panel {
  public:
    Panel(Plot& plot, const FlowResult& flow, int threads, const Rect& frame)
        : plot_(plot), frame_(frame), rows_(flow.rows_with(threads)), points_(points_of(rows_)), front_(front_of(points_)),
          labels_(frame.grown(-3.0)) {
        std::vector<double> costs, errors;
        for (const CostError& point : points_) {
            if (point.cost > 0.0)
                costs.push_back(point.cost);
            if (point.error > 0.0 && std::isfinite(point.error))
                errors.push_back(std::min(point.error, k_worst_drawn));
        }
        cost_ = axis_around(costs, 3.5, 1.4, frame.x, frame.right()); // room for labels at the left
        error_ = axis_around(errors, 2.2, 1.5, frame.bottom(), frame.y);
    }

    void add_axes(const std::string& title, const std::string& runner) {
        const Line grid{.colour = k_hairline, .width = 1.0};
        words(title, {frame_.x, frame_.y - 14.0}, {.size = 17.0, .colour = k_ink, .bold = true});
        for (const double value : cost_.ticks()) {
            const double x = cost_.at(value);
            plot_.marks.emplace_back(PlotLine{{{x, frame_.y}, {x, frame_.bottom()}}, grid});
            words(time_text(value), {x, frame_.bottom() + 18.0},
                  {.size = k_tick_size, .colour = k_dim_ink, .align = Align::centre});
        }
        for (const double value : error_.ticks()) {
            const double y = error_.at(value);
            plot_.marks.emplace_back(PlotLine{{{frame_.x, y}, {frame_.right(), y}}, grid});
            words(share_text(value), {frame_.x - 8.0, y + 4.5},
                  {.size = k_tick_size, .colour = k_dim_ink, .align = Align::right});
        }
        plot_.marks.emplace_back(PlotPolygon{
            {{frame_.x, frame_.y}, {frame_.right(), frame_.y}, {frame_.right(), frame_.bottom()}, {frame_.x, frame_.bottom()}},
            k_nothing,
            {.colour = k_dim_ink, .width = 1.0}});
        words(message("computing time for one second of flow (", runner, ")"), {frame_.middle().x, frame_.bottom() + 40.0},
              {.size = 14.0, .colour = k_ink, .align = Align::centre});
        words("error of the velocity at the end", {frame_.x - 66.0, frame_.middle().y},
              {.size = 14.0, .colour = k_ink, .align = Align::centre, .upward = true});
    }

    void add_runs() {
        std::vector<bool> on_front(rows_.size(), false);
        for (const std::size_t n : front_)
            on_front[n] = true;
        for (std::size_t n = 0; n < rows_.size(); ++n) {
            if (on_front[n])
                continue;
            const glm::dvec2 at = place(n);
            marker(n, k_marker, 0.42);
            labels_.avoid(around(at, k_marker), 0.4);
        }
        for (std::size_t n = 0; n < rows_.size(); ++n)
            if (rows_[n].method == k_default_method)
                plot_.marks.emplace_back(PlotCircle{place(n), k_ring, k_nothing, {.colour = k_ink, .width = 1.4}});
        add_front();
    }

  private:
    void add_front() {
        std::vector<glm::dvec2> line;
        for (const std::size_t n : front_)
            line.push_back(place(n));
        if (line.size() > 1)
            plot_.marks.emplace_back(PlotLine{line, {.colour = k_ink.faded(0.75), .width = 1.8}});
        for (std::size_t n = 0; n + 1 < line.size(); ++n)
            for (int part = 1; part < 12; ++part)
                labels_.avoid(around(line[n] + part / 12.0 * (line[n + 1] - line[n]), 2.0), 1.0);
        for (const std::size_t n : front_) {
            marker(n, k_front_marker, 1.0, {.colour = k_ink, .width = 1.0});
            labels_.avoid(around(place(n), rows_[n].method == k_default_method ? k_ring : k_front_marker), 12.0);
        }
        // The grid is named where it changes.
        glm::ivec3 named(0);
        for (const std::size_t n : front_) {
            const ParetoRow& row = rows_[n];
            const std::string text =
                row.cells == named ? "CFL " + scene::figure(row.cfl) : grid_name(row.cells) + ", CFL " + scene::figure(row.cfl);
            named = row.cells;
            const LabelPlaces::Place label = labels_.find(text, k_label_size, place(n));
            if (label.far)
                plot_.marks.emplace_back(PlotLine{{place(n), label.near}, {.colour = k_dim_ink, .width = 0.8}});
            words(text, label.at, {.size = k_label_size, .colour = k_ink, .align = label.align});
        }
    }

    void words(const std::string& text, glm::dvec2 at, const Words& how) { plot_.marks.emplace_back(PlotWords{text, at, how}); }

    void marker(std::size_t n, double radius, double strength, const Line& outline = k_no_outline) {
        const Method& method = rows_[n].method;
        add_marker(plot_, method.pressure, place(n), radius, colour_of(method.scheme, method.interpolation).faded(strength),
                   outline);
    }

    // On the upper edge where there is no error to speak of.
    [[nodiscard]] glm::dvec2 place(std::size_t n) const {
        const double error = points_[n].error;
        const bool drawn = std::isfinite(error) && error <= k_worst_drawn;
        return {cost_.at(points_[n].cost), drawn ? error_.at(std::max(error, error_.low)) : frame_.y};
    }

    static Rect around(glm::dvec2 at, double radius) { return {at.x - radius, at.y - radius, 2.0 * radius, 2.0 * radius}; }

    Plot& plot_;
    Rect frame_;
    std::vector<ParetoRow> rows_;
    std::vector<CostError> points_;
    std::vector<std::size_t> front_;
    LogAxis cost_, error_;
    LabelPlaces labels_;
};

} // namespace

void add_panel(Plot& plot, const FlowResult& flow, int threads, const std::string& runner, const Rect& frame) {
    Panel panel(plot, flow, threads, frame);
    panel.add_axes(flow.title, runner);
    panel.add_runs();
}

} // namespace windrow::cli

// Springs as bytes and back: their number, which arrays there are, and each array whole.
#include "coupling/spring.h"
#include "fluid/core/archive.h"

#include <algorithm>
#include <cmath>

namespace windrow {
namespace {

using detail::message;

constexpr double k_most = 1e15; // beyond, a step of the stiffest spring is no float

template <class Real>
constexpr detail::Format k_springs_format{"WINDSPRG", detail::Layout("springs 1").with<Real>().version(), "saved springs",
                                          "save_springs"};

template <class Real>
Result<void> check(const SpringBatch<Real>& batch, std::size_t targets) {
    const std::size_t count = batch.place.size();
    const auto fits = [&](std::size_t size) { return size == count || size == 0; };
    if (batch.velocity.size() != count || targets != count || !fits(batch.place_remainder.size()) ||
        batch.place_remainder.size() != batch.velocity_remainder.size() || !fits(batch.place_previous.size()))
        return Error{message("the springs have ", count, " places, ", batch.velocity.size(), " velocities, ", targets,
                             " targets, ", batch.place_remainder.size(), " and ", batch.velocity_remainder.size(),
                             " remainders and ", batch.place_previous.size(), " previous places: give one each.")};
    return {};
}

} // namespace

template <class Real>
Result<std::vector<std::byte>> save_springs(const SpringBatch<Real>& batch) {
    if (auto valid = check(batch, batch.target_now.size()); !valid)
        return valid.failure();
    return detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        detail::Writer writer(16 + 6 * batch.place.size() * sizeof(Real));
        writer(static_cast<std::uint64_t>(batch.place.size()), !batch.place_remainder.empty(), !batch.place_previous.empty());
        for (const std::span<const Real> values :
             {std::span<const Real>(batch.place), std::span<const Real>(batch.velocity), batch.target_now,
              std::span<const Real>(batch.place_remainder), std::span<const Real>(batch.velocity_remainder),
              std::span<const Real>(batch.place_previous)})
            for (const Real& value : values)
                writer(value);
        return std::move(writer).finish(k_springs_format<Real>);
    });
}

template <class Real>
Result<void> load_springs(std::span<const std::byte> bytes, const SpringBatch<Real>& batch, std::span<Real> target) {
    if (auto valid = check(batch, target.size()); !valid)
        return valid;
    return detail::where_memory_lasts([&]() -> Result<void> {
        const std::span<Real> arrays[] = {batch.place,           batch.velocity,           target,
                                          batch.place_remainder, batch.velocity_remainder, batch.place_previous};
        std::vector<Real> values;
        auto read = detail::read_sealed(bytes, k_springs_format<Real>, [&](detail::Reader& reader) {
            std::uint64_t count = 0;
            bool remainders = false, previous = false;
            reader(count, remainders, previous);
            if (!reader.rejected() &&
                (count != batch.place.size() || remainders == batch.place_remainder.empty() ||
                 previous == batch.place_previous.empty()) &&
                count > 0)
                return reader.reject("it has ", count, " springs ", remainders ? "with" : "without", " remainders and ",
                                     previous ? "with" : "without", " previous places, and the arrays are of ",
                                     batch.place.size(), ": give arrays as they were saved.");
            const std::size_t all = batch.place.size() * (3 + (remainders ? 2 : 0) + (previous ? 1 : 0));
            if (!reader.can_hold(all, sizeof(Real)))
                return;
            values.resize(all);
            for (Real& value : values) {
                reader(value);
                reader.require(std::abs(static_cast<double>(value)) <= k_most, "a spring is out of range.");
            }
        });
        if (!read)
            return read;
        auto from = values.begin();
        for (const std::span<Real> array : arrays) {
            std::copy_n(from, array.size(), array.begin());
            from += static_cast<std::ptrdiff_t>(array.size());
        }
        return {};
    });
}

template WINDROW_API Result<std::vector<std::byte>> save_springs<float>(const SpringBatch<float>&);
template WINDROW_API Result<std::vector<std::byte>> save_springs<double>(const SpringBatch<double>&);
template WINDROW_API Result<void> load_springs<float>(std::span<const std::byte>, const SpringBatch<float>&, std::span<float>);
template WINDROW_API Result<void> load_springs<double>(std::span<const std::byte>, const SpringBatch<double>&, std::span<double>);

} // namespace windrow

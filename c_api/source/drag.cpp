// Calls of drag.h.
#include "c_api/drag.h"

#include "c_api/source/tables.h"
#include "fluid/core/message.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using namespace windrow;
using namespace windrow::c_api;

namespace {

windrow_drag_id in_c(DragId id) {
    return {id.slot, id.generation, id.owner};
}

/// The outcome of a call with an id; its class is WINDROW_STALE where the id names nothing.
template <class Value>
windrow_result done_with_drag(const windrow_wind* wind, DragId id, const Result<Value>& outcome) {
    if (!outcome && wind->control->drag().find(id) == nullptr)
        return fail(WINDROW_STALE, outcome.error());
    return done(outcome);
}

template <class C>
windrow_result add_drag(windrow_wind* wind, const C* deposit, windrow_drag_id* id) {
    return call({{wind, "wind"}, {deposit, "deposit"}}, [&] {
        return with(deposit, [&](const auto& wanted) -> windrow_result {
            const Result<DragId> added = wind->control->drag().add(wanted);
            if (added && id != nullptr)
                *id = in_c(*added);
            return done(added);
        });
    });
}

template <class C>
windrow_result set_drag(windrow_wind* wind, windrow_drag_id id, const C* deposit) {
    return call({{wind, "wind"}, {deposit, "deposit"}}, [&] {
        return with(deposit, [&](const auto& wanted) {
            const auto named = id_of<DragId>(id);
            return done_with_drag(wind, named, wind->control->drag().set(named, wanted));
        });
    });
}

/// Runs use(deposit) on the deposit that an id names.
template <class Use>
windrow_result with_drag(const windrow_wind* wind, windrow_drag_id id, const Use& use) {
    const DragDeposit* const deposit = wind->control->drag().find(id_of<DragId>(id));
    if (deposit == nullptr)
        return fail(WINDROW_STALE, "the deposit's id names none: it was removed, or another wind gave it; drop the id.");
    return use(*deposit);
}

template <class C>
windrow_result get_drag(const windrow_wind* wind, windrow_drag_id id, C* out) {
    return call({{wind, "wind"}, {out, "deposit"}}, [&]() -> windrow_result {
        if (const windrow_result outcome = check_output(out); outcome != WINDROW_OK)
            return outcome;
        return with_drag(wind, id, [&](const DragDeposit& deposit) -> windrow_result {
            const auto* const kind = std::get_if<typename Fields<C>::Cpp>(&deposit);
            if (kind == nullptr)
                return fail(WINDROW_REJECTED, detail::message("the deposit is not a ", std::string_view(Fields<C>::k_name),
                                                              ": ask windrow_wind_drag_kind first."));
            give_cpp(*kind, out);
            return WINDROW_OK;
        });
    });
}

} // namespace

WINDROW_C_INIT(windrow_plant_drag)
WINDROW_C_INIT(windrow_belt_drag)
WINDROW_C_INIT(windrow_drag_force)
WINDROW_EXPORT windrow_result windrow_wind_add_plant_drag(windrow_wind* wind, const windrow_plant_drag* plant,
                                                          windrow_drag_id* id) {
    return add_drag(wind, plant, id);
}
WINDROW_EXPORT windrow_result windrow_wind_add_belt_drag(windrow_wind* wind, const windrow_belt_drag* belt, windrow_drag_id* id) {
    return add_drag(wind, belt, id);
}
WINDROW_EXPORT windrow_result windrow_wind_add_plants(windrow_wind* wind, const windrow_plant_drag* plants, uint64_t count,
                                                      windrow_drag_id* ids) {
    return call({{wind, "wind"}, {count > 0 ? plants : static_cast<const void*>(wind), "plants"}}, [&]() -> windrow_result {
        if (count > DragField::k_capacity)
            return fail(WINDROW_REJECTED,
                        detail::message("there are ", count, " plants: give at most ", DragField::k_capacity, "."));
        Reasons reasons;
        std::vector<DragDeposit> deposits;
        deposits.reserve(static_cast<std::size_t>(count));
        const auto* at = reinterpret_cast<const unsigned char*>(plants);
        for (std::uint64_t n = 0; n < count && reasons.empty(); ++n) {
            const auto* const from = reinterpret_cast<const windrow_plant_drag*>(at);
            const std::string name = detail::message("plants[", n, "]");
            if (from->struct_size != plants->struct_size || from->struct_size % alignof(windrow_plant_drag) != 0) {
                reasons.add(name, " has struct_size ", from->struct_size, ": give all that of windrow_plant_drag.");
                break;
            }
            PlantDrag wanted;
            read_versioned(reasons, Path{nullptr, name.c_str()}, from, wanted);
            deposits.emplace_back(wanted);
            at += from->struct_size;
        }
        if (!reasons.empty())
            return fail(WINDROW_REJECTED, reasons.take());
        std::vector<DragId> added(ids != nullptr ? deposits.size() : 0);
        const auto outcome = wind->control->drag().add(deposits, added);
        for (std::size_t n = 0; outcome && n < added.size(); ++n)
            ids[n] = in_c(added[n]);
        return done(outcome);
    });
}
WINDROW_EXPORT windrow_result windrow_wind_set_plant_drag(windrow_wind* wind, windrow_drag_id id,
                                                          const windrow_plant_drag* plant) {
    return set_drag(wind, id, plant);
}
WINDROW_EXPORT windrow_result windrow_wind_set_belt_drag(windrow_wind* wind, windrow_drag_id id, const windrow_belt_drag* belt) {
    return set_drag(wind, id, belt);
}
WINDROW_EXPORT windrow_result windrow_wind_get_plant_drag(const windrow_wind* wind, windrow_drag_id id,
                                                          windrow_plant_drag* plant) {
    return get_drag(wind, id, plant);
}
WINDROW_EXPORT windrow_result windrow_wind_get_belt_drag(const windrow_wind* wind, windrow_drag_id id, windrow_belt_drag* belt) {
    return get_drag(wind, id, belt);
}
WINDROW_EXPORT windrow_result windrow_wind_drag_kind(const windrow_wind* wind, windrow_drag_id id, windrow_drag_kind* kind) {
    return call({{wind, "wind"}, {kind, "kind"}}, [&] {
        return with_drag(wind, id, [&](const DragDeposit& deposit) -> windrow_result {
            *kind = static_cast<windrow_drag_kind>(deposit.index());
            return WINDROW_OK;
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_remove_drag(windrow_wind* wind, windrow_drag_id id) {
    return call({{wind, "wind"}}, [&] {
        const auto named = id_of<DragId>(id);
        return done_with_drag(wind, named, wind->control->drag().remove(named));
    });
}
WINDROW_EXPORT int32_t windrow_wind_drag_count(const windrow_wind* wind) {
    return value_of(wind, "wind", [&] { return wind->control->drag().count(); });
}
WINDROW_EXPORT windrow_result windrow_wind_drag_force_on(const windrow_wind* wind, windrow_drag_id id,
                                                         windrow_drag_force* force) {
    return call({{wind, "wind"}, {force, "force"}}, [&]() -> windrow_result {
        if (const windrow_result outcome = check_output(force); outcome != WINDROW_OK)
            return outcome;
        const auto named = id_of<DragId>(id);
        const Result<DragForce> acting = wind->reader->force_on(named);
        if (acting)
            give_cpp(*acting, force);
        return done_with_drag(wind, named, acting);
    });
}

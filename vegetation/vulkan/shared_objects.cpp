#include "vegetation/vulkan/shared_objects.h"

#include "vegetation/vulkan/objects.h"

#include <algorithm>

namespace windrow::vegetation::engine {

SharedObjects::Shared::~Shared() = default;

std::shared_ptr<const SharedObjects::Shared> SharedObjects::find(Objects& objects, const SharedKey& key,
                                                                 const std::function<HandleBits(Objects&)>& make) {
    std::erase_if(found_, [](const auto& each) { return each.second.expired(); });
    if (const auto there = found_.find(key.bytes()); there != found_.end())
        return there->second.lock();
    auto made = std::make_shared<Shared>();
    for (const auto& [kind, handle] : key.parts()) {
        std::shared_ptr<const Shared> part;
        for (const auto& [bytes, held] : found_)
            if (const auto each = held.lock(); each->kind == kind && each->handle == handle)
                part = each;
        if (!part)
            return nullptr;
        made->parts.push_back(std::move(part));
    }
    made->kind = key.kind();
    made->owner = std::make_unique<Objects>(objects.device());
    made->handle = make(*made->owner);
    found_.emplace(key.bytes(), made);
    return made;
}

std::size_t SharedObjects::count() const {
    return static_cast<std::size_t>(std::ranges::count_if(found_, [](const auto& each) { return !each.second.expired(); }));
}

} // namespace windrow::vegetation::engine

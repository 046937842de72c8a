#include "cloth/contact/contact_log.h"

#include <algorithm>
#include <functional>

namespace weft {

namespace {

bool is_stronger(const ContactLog::Entry& a, const ContactLog::Entry& b) {
    return a.strength > b.strength || (a.strength == b.strength && a.order < b.order);
}

}  // namespace

void ContactLog::add(const Entry& entry) noexcept {
    if (entries_.size() < room_) {
        entries_.push_back(entry);
        if (entries_.size() == room_) std::ranges::make_heap(entries_, is_stronger);
        return;
    }
    if (room_ == 0 || !is_stronger(entry, entries_.front())) return;
    std::ranges::pop_heap(entries_, is_stronger);
    entries_.back() = entry;
    std::ranges::push_heap(entries_, is_stronger);
}

ContactReports::ContactReports(std::size_t room, int threads) {
    logs_.reserve(static_cast<std::size_t>(threads));
    for (int thread = 0; thread < threads; ++thread) logs_.emplace_back(room);
    ranks_.reserve(room);
    list_.reserve(room);
}

void ContactReports::clear() noexcept {
    for (ContactLog& log : logs_) log.clear();
    list_.clear();
}

void ContactReports::write_list() noexcept {
    if (!std::ranges::is_sorted(ranks_, {}, &Rank::order)) std::ranges::sort(ranks_, {}, &Rank::order);
    const std::span<const ContactLog::Entry> entries = logs_.front().entries();
    list_.clear();
    for (const Rank& rank : ranks_) list_.push_back(entries[rank.entry].contact);
}

}  // namespace weft

#pragma once
// The contacts of a step that a World reports: the strongest ones, whichever thread found them.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/contact.h"

namespace weft {

/// Keeps the strongest contacts of those added, as many as there is room for. Of equally strong contacts the
/// lower order stays, so the result does not depend on the order of insertion.
class ContactLog {
  public:
    struct Entry {
        Contact contact;
        float strength;       // length of the contact's impulse [N s]
        std::uint64_t order;  // different for each contact of a step
    };

    ContactLog() = default;
    explicit ContactLog(std::size_t room) : room_(room) { entries_.reserve(room); }
    void clear() noexcept { entries_.clear(); }

    /// Whether add() could keep a contact of this strength; if not, the caller need not make it.
    [[nodiscard]] bool wants(float strength) const noexcept {
        return entries_.size() < room_ || (room_ > 0 && strength >= entries_.front().strength);
    }
    void add(const Entry& entry) noexcept;
    [[nodiscard]] std::span<const Entry> entries() const noexcept { return entries_; }

  private:
    std::size_t room_ = 0;
    std::vector<Entry> entries_;  // a heap once full, the weakest contact on top
};

/// A log for each thread, and the list that is gathered from all logs.
class ContactReports {
  public:
    ContactReports() = default;
    ContactReports(std::size_t room, int threads);

    void clear() noexcept;
    [[nodiscard]] ContactLog& of_thread(std::size_t thread) noexcept { return logs_[thread]; }
    /// Makes the list of the contacts for which keep(contact) is true, in ascending order.
    template <class Keep>
    void gather(const Keep& keep) noexcept {
        for (std::size_t thread = 1; thread < logs_.size(); ++thread)
            for (const ContactLog::Entry& entry : logs_[thread].entries()) logs_.front().add(entry);
        const std::span<const ContactLog::Entry> entries = logs_.front().entries();
        ranks_.clear();
        for (std::size_t k = 0; k < entries.size(); ++k)
            if (keep(entries[k].contact)) ranks_.push_back({entries[k].order, static_cast<std::uint32_t>(k)});
        write_list();
    }
    [[nodiscard]] std::span<const Contact> list() const noexcept { return list_; }

  private:
    struct Rank {
        std::uint64_t order;
        std::uint32_t entry;
    };
    void write_list() noexcept;

    std::vector<ContactLog> logs_;
    std::vector<Rank> ranks_;
    std::vector<Contact> list_;
};

}  // namespace weft

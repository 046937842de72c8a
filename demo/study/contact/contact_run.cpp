#include "demo/study/contact/contact_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "demo/study/must.h"

namespace weft::study {

namespace {

WorldSettings on_one_thread(WorldSettings settings) {
    settings.threads = 1;
    return settings;
}

/// Time that this thread has had on the processor [s].
double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

class ContactRun::Handles final : public SceneHandles {
  public:
    explicit Handles(ContactRun& run) : run_(run) {}
    void move_pin(std::size_t cloth, std::uint32_t vertex, const Vec3& target) const override {
        must(run_.world_.move_pin(run_.cloths_.at(cloth), vertex, target));
        run_.targets_.push_back({cloth, vertex, target});
    }
    void unpin(std::size_t cloth, const std::vector<std::uint32_t>& vertices) const override {
        must(run_.world_.unpin(run_.cloths_.at(cloth), vertices));
    }
    void move_collider(std::size_t collider, const Collider& target) const override {
        must(run_.world_.move_collider(run_.colliders_.at(collider), target));
    }

  private:
    ContactRun& run_;
};

ContactRun::ContactRun(ContactScene scene, SelfCollisionMethod method)
    : scene_(std::move(scene)), world_(must(World::create(on_one_thread(scene_.world)))) {
    for (PlacedCloth& cloth : scene_.cloths) {
        demo::set_method(cloth.settings.self_collision, method);
        cloths_.push_back(must(world_.add_cloth(cloth.mesh, cloth.settings)));
        if (!cloth.pins.empty()) must(world_.pin(cloths_.back(), cloth.pins));
    }
    for (const Collider& collider : scene_.colliders)
        colliders_.push_back(must(world_.add_collider(collider)));
}

double ContactRun::step() {
    ++steps_;
    targets_.clear();
    if (scene_.move) scene_.move(Handles(*this), time());
    const double begun = thread_seconds();
    world_.step(static_cast<float>(ContactScene::step()));
    return thread_seconds() - begun;
}

std::uint32_t ContactRun::particles() const {
    std::uint32_t sum = 0;
    for (const ClothId id : cloths_) sum += must(world_.cloth_info(id)).particles;
    return sum;
}

double ContactRun::pin_lag() const {
    double most = 0;
    for (const auto& [cloth, vertex, place] : targets_) {
        const ClothView& view = *world_.cloth(cloths_[cloth]);
        const Vec4& p = view.positions[view.vertex_to_particle[vertex]];
        most = std::max(most, static_cast<double>(std::hypot(p.x - place.x, p.y - place.y, p.z - place.z)));
    }
    return most;
}

TriangleSoup ContactRun::soup() const {
    TriangleSoup soup;
    for (const ClothId id : cloths_) soup.add(*world_.cloth(id));
    return soup;
}

}  // namespace weft::study

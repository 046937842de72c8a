#include "demo/study/contact/contact_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "demo/study/must.h"

namespace weft::study {

namespace {

WorldSettings with_threads(WorldSettings settings, int threads) {
    settings.threads = threads;
    return settings;
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

ContactRun::ContactRun(ContactScene scene, SelfCollisionMethod method, int threads)
    : scene_(std::move(scene)), world_(must(World::create(with_threads(scene_.world, threads)))) {
    for (PlacedCloth& cloth : scene_.cloths) {
        demo::set_method(cloth.settings.self_collision, method);
        cloths_.push_back(must(world_.add_cloth(cloth.mesh, cloth.settings)));
        if (!cloth.pins.empty()) must(world_.pin(cloths_.back(), cloth.pins));
    }
    for (const Collider& collider : scene_.colliders)
        colliders_.push_back(must(world_.add_collider(collider)));
}

double ContactRun::step() {
    using Clock = std::chrono::steady_clock;
    ++steps_;
    targets_.clear();
    if (scene_.move) scene_.move(Handles(*this), time());
    const auto begun = Clock::now();
    world_.step(static_cast<float>(ContactScene::step()));
    return std::chrono::duration<double>(Clock::now() - begun).count();
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

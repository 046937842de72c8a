#include "demo/study/contact/contact_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <Eigen/Geometry>
#include <limits>
#include <set>
#include <utility>

#include "demo/character/garment/garment_mesh.h"
#include "demo/must.h"

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

namespace {

using Eigen::Vector3d;

Vector3d in_double(const Vec3& p) {
    return Eigen::Vector3f(p.x, p.y, p.z).cast<double>();
}

Vector3d in_double(const Vec4& p) {
    return Eigen::Vector3f(p.x, p.y, p.z).cast<double>();
}

/// True if an edge is a sheet's diagonal, which is a shear spring.
bool is_diagonal(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
    return mesh.columns > 0 && a / mesh.columns != b / mesh.columns && a % mesh.columns != b % mesh.columns;
}

/// Calls `visit(position, velocity, mass)` for each free particle.
template <class Visit>
void for_free(const ContactRun& run, const Visit& visit) {
    for (const ClothId id : run.cloths()) {
        const ClothView& view = *run.world().cloth(id);
        for (std::size_t i = 0; i < view.positions.size(); ++i) {
            const double inverse = static_cast<double>(view.positions[i].w);
            if (inverse > 0) visit(in_double(view.positions[i]), in_double(view.velocities[i]), 1 / inverse);
        }
    }
}

struct DistanceTo {
    Vector3d p;
    double operator()(const Sphere& s) const {
        return (p - in_double(s.center)).norm() - static_cast<double>(s.radius);
    }
    double operator()(const Capsule& c) const {
        const Vector3d a = in_double(c.a), along = in_double(c.b) - a;
        const double length = along.squaredNorm();
        const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
        return (a + t * along - p).norm() - static_cast<double>(c.radius);
    }
    double operator()(const TaperedCapsule& c) const {  // of the nearest of 1001 balls along it
        const Vector3d a = in_double(c.a), along = in_double(c.b) - a;
        const double first = static_cast<double>(c.radius_a), last = static_cast<double>(c.radius_b);
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= 1000; ++k) {
            const double t = k / 1000.0;
            least = std::min(least, (a + t * along - p).norm() - (first + t * (last - first)));
        }
        return least;
    }
    double operator()(const Box& box) const {
        const Rotation& r = box.rotation;
        const Eigen::Quaterniond turn(static_cast<double>(r.w), static_cast<double>(r.x),
                                      static_cast<double>(r.y), static_cast<double>(r.z));
        const Vector3d q = turn.normalized().conjugate() * (p - in_double(box.center));
        const Vector3d beyond = q.cwiseAbs() - in_double(box.half_extents);
        return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
    }
    double operator()(const PlacedShape&) const {  // no scene of the study has one
        return std::numeric_limits<double>::infinity();
    }
    double operator()(const Plane& plane) const {
        return in_double(plane.normal).normalized().dot(p) - static_cast<double>(plane.offset);
    }
};

}  // namespace

EdgeStretch::EdgeStretch(const ContactRun& run) {
    for (std::size_t c = 0; c < run.cloths().size(); ++c) {
        const Mesh& mesh = run.scene().cloths[c].mesh;
        const ClothView& view = *run.world().cloth(run.cloths()[c]);
        std::vector<Edge> edges;
        std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
        for (const Triangle& t : mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
                if (is_diagonal(mesh, a, b) || !seen.emplace(a, b).second) continue;
                const double rest = static_cast<double>(demo::rest_length(mesh, a, b));
                if (rest > 0) edges.push_back({view.vertex_to_particle[a], view.vertex_to_particle[b], rest});
            }
        }
        edges_.push_back(std::move(edges));
    }
}

EdgeStretch::Stretch EdgeStretch::of(const ContactRun& run) const {
    Stretch stretch;
    std::size_t count = 0;
    for (std::size_t c = 0; c < edges_.size(); ++c) {
        const ClothView& view = *run.world().cloth(run.cloths()[c]);
        for (const auto& [a, b, rest] : edges_[c]) {
            const double ratio = (in_double(view.positions[a]) - in_double(view.positions[b])).norm() / rest;
            stretch.most = std::max(stretch.most, ratio);
            stretch.mean += ratio;
            ++count;
        }
    }
    stretch.mean /= static_cast<double>(std::max<std::size_t>(count, 1));
    return stretch;
}

double rms_speed(const ContactRun& run) {
    double sum = 0, all = 0;
    for_free(run, [&](const Vector3d&, const Vector3d& velocity, double mass) {
        sum += mass * velocity.squaredNorm();
        all += mass;
    });
    return all > 0 ? std::sqrt(sum / all) : 0;
}

double deepest_in_colliders(const ContactRun& run) {
    double least = std::numeric_limits<double>::infinity();
    for (const ColliderId id : run.colliders()) {
        const Collider collider = must(run.world().collider(id));
        for_free(run, [&](const Vector3d& p, const Vector3d&, double) {
            least = std::min(least, std::visit(DistanceTo{p}, collider.shape));
        });
    }
    return static_cast<double>(run.scene().cloths.front().settings.thickness) - least;
}

Vector3d momentum(const ContactRun& run) {
    Vector3d sum = Vector3d::Zero();
    for_free(run, [&](const Vector3d&, const Vector3d& velocity, double mass) { sum += mass * velocity; });
    return sum;
}

std::vector<double> layer_heights(const ContactRun& run) {
    std::vector<double> heights;
    for (std::size_t c = 0; c < run.cloths().size(); ++c) {
        const PlacedCloth& cloth = run.scene().cloths[c];
        const ClothView& view = *run.world().cloth(run.cloths()[c]);
        for (std::size_t k = 0; k < cloth.layers.size(); ++k) {
            const std::size_t end =
                k + 1 < cloth.layers.size() ? cloth.layers[k + 1] : cloth.mesh.positions.size();
            double sum = 0;
            for (std::size_t i = cloth.layers[k]; i < end; ++i)
                sum += static_cast<double>(view.positions[view.vertex_to_particle[i]].y);
            heights.push_back(sum / static_cast<double>(end - cloth.layers[k]));
        }
    }
    return heights;
}

std::size_t layers_in_order(const std::vector<double>& heights) {
    std::size_t count = 0;
    for (std::size_t k = 0; k + 1 < heights.size(); ++k)
        if (heights[k + 1] > heights[k]) ++count;
    return count;
}

}  // namespace weft::study

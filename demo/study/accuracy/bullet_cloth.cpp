#include "demo/study/accuracy/bullet_cloth.h"

#include <btBulletDynamicsCommon.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <ctime>

namespace weft::study {

namespace {

btVector3 to_bullet(const Vector3& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

class BulletCloth final : public Peer {
  public:
    BulletCloth(const StudyScene& scene, const Cloth& cloth, int iterations) {
        const btVector3 gravity = to_bullet(to_vector(scene.world.gravity));
        world_.setGravity(gravity);
        btSoftBodyWorldInfo& info = world_.getWorldInfo();
        info.m_gravity = gravity;
        info.air_density = 0;
        info.m_sparsesdf.Initialize();
        std::vector<btVector3> places;
        std::vector<btScalar> masses;
        for (const Vec4& p : cloth.state.positions.span()) {
            places.push_back(to_bullet(xyz(p)));
            masses.push_back(p.w > 0 ? 1 / static_cast<btScalar>(p.w) : 0);  // 0: pinned
        }
        body_ = std::make_unique<btSoftBody>(&info, static_cast<int>(places.size()), places.data(),
                                             masses.data());
        link(cloth.model);
        body_->m_cfg.piterations = iterations;
        body_->m_cfg.kDP =
            static_cast<btScalar>(scene.cloth.air_damping * scene.frame);  // of velocity, a step
        world_.addSoftBody(body_.get());
    }
    ~BulletCloth() override { world_.removeSoftBody(body_.get()); }

    double step(float seconds) override {
        const std::clock_t start = std::clock();
        world_.stepSimulation(static_cast<btScalar>(seconds), 0);
        return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }
    [[nodiscard]] std::vector<Eigen::Vector3d> positions() const override {
        std::vector<Eigen::Vector3d> all;
        for (int i = 0; i < body_->m_nodes.size(); ++i) {
            const btVector3& x = body_->m_nodes[i].m_x;
            all.emplace_back(x.x(), x.y(), x.z());
        }
        return all;
    }

  private:
    /// Bullet's own bending links would span two cells: bending is left to the diagonals.
    void link(const ClothModel& model) {
        for (std::uint32_t i = 0; i < model.particle_count; ++i) {
            for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
                const std::uint32_t j = model.neighbours[e];
                if (j < i || model.kinds[e] == SpringKind::bending) continue;
                body_->appendLink(static_cast<int>(i), static_cast<int>(j));
                btSoftBody::Link& added = body_->m_links[body_->m_links.size() - 1];
                added.m_rl = static_cast<btScalar>(model.rest_lengths[e]);
            }
        }
    }

    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::unique_ptr<btSoftBody> body_;
};

}  // namespace

std::unique_ptr<Peer> make_bullet_cloth(const StudyScene& scene, const Cloth& cloth, int iterations) {
    return std::make_unique<BulletCloth>(scene, cloth, iterations);
}

}  // namespace weft::study

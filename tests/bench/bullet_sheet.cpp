#include "tests/bench/bullet_sheet.h"

#include <btBulletDynamicsCommon.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

namespace weft::bench {

namespace {

constexpr int iterations = 20, warm_up_frames = 45;

}  // namespace

struct BulletSheet::World {
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btSoftRigidDynamicsWorld dynamics{&dispatcher, &broadphase, &solver, &configuration};
    btSphereShape sphere{0.3f};
    std::unique_ptr<btRigidBody> ball;
    std::unique_ptr<btSoftBody> cloth;

    ~World() {
        if (cloth) dynamics.removeSoftBody(cloth.get());
        if (ball) dynamics.removeRigidBody(ball.get());
    }
};

BulletSheet::BulletSheet(std::uint32_t side, bool on_sphere) : world_(std::make_unique<World>()) {
    World& w = *world_;
    const btVector3 gravity(0, btScalar(-9.81), 0);
    w.dynamics.setGravity(gravity);
    btSoftBodyWorldInfo& info = w.dynamics.getWorldInfo();
    info.m_gravity = gravity;
    info.air_density = 0;
    info.m_sparsesdf.Initialize();

    const btScalar y = on_sphere ? btScalar(0.32) : btScalar(0), half = btScalar(0.5);
    const int count = static_cast<int>(side), corners = on_sphere ? 0 : 1 + 2;
    w.cloth.reset(btSoftBodyHelpers::CreatePatch(info, {-half, y, -half}, {half, y, -half}, {-half, y, half},
                                                 {half, y, half}, count, count, corners, true));
    w.cloth->setTotalMass(btScalar(0.2));
    w.cloth->m_cfg.piterations = iterations;
    w.cloth->m_cfg.collisions = btSoftBody::fCollision::SDF_RS;
    w.cloth->m_cfg.kDF = btScalar(1);
    w.dynamics.addSoftBody(w.cloth.get());
    if (on_sphere) {
        w.ball =
            std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &w.sphere));
        w.dynamics.addRigidBody(w.ball.get());
    }
    for (int i = 0; i < warm_up_frames; ++i) frame();
}

BulletSheet::~BulletSheet() = default;

void BulletSheet::frame() {
    world_->dynamics.stepSimulation(btScalar(1) / 60, 0);
}

}  // namespace weft::bench

#pragma once
// Two nodes of Godot's: a World, and a cloth in it.

#include <weft/weft.h>

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <optional>
#include <vector>

/// Steps all WeftCloths below it, after their own physics process. Weft works in Godot's global coordinates:
/// right-handed, +Y up, metres.
class WeftWorld : public godot::Node3D {
    GDCLASS(WeftWorld, godot::Node3D)

  public:
    void _enter_tree() override;
    void _exit_tree() override;
    void _physics_process(double seconds) override;

    void set_wind(const godot::Vector3& metres_a_second);
    godot::Vector3 get_wind() const { return wind_; }
    weft::World* world() { return world_ ? &*world_ : nullptr; }

  protected:
    static void _bind_methods();

  private:
    void apply_wind();

    godot::Vector3 wind_{2, 0, 1};
    std::optional<weft::World> world_;
};

/// A sheet of 1 m by 1 m whose upper edge is attached to the node.
class WeftCloth : public godot::MeshInstance3D {
    GDCLASS(WeftCloth, godot::MeshInstance3D)

  public:
    void _ready() override;
    void _exit_tree() override;
    void _physics_process(double seconds) override;
    void _process(double seconds) override;

  protected:
    static void _bind_methods() {}

  private:
    weft::World* world() const;
    void take_triangles();

    weft::ClothId cloth_{};
    std::vector<std::uint32_t> held_;
    std::vector<weft::Vec3> at_rest_;  // of the held vertices, in the node's own space
    std::vector<weft::Vec3> targets_;
    godot::PackedVector3Array positions_, previous_, normals_;
    godot::PackedInt32Array triangles_;
    godot::Ref<godot::ArrayMesh> mesh_;
};

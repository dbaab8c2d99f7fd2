// What the loader reads is what libsdformat reads, in the worlds of the repository and in many drawn ones:
// where links and shapes are, their masses, joints and physics. Built where libsdformat is installed; nothing
// else uses it.
#include "random_sdf.h"

#include "loader/read/document.h"
#include "loader/read/read_world.h"
#include "loader/read/regular_file.h"
#include "loader/load_world.h"

#include <gtest/gtest.h>
#include <sdf/sdf.hh>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

namespace {

using small_world::TestFolder;

// Numbers of every thing by what it is and its name, "link m::l".
using Facts = std::map<std::string, std::vector<double>>;
using Numbers = std::vector<double>;

constexpr double kNone = 1e16;  // SDF's mark for no limit

// Of any number: rounding alone; and that of libsdformat, which writes the pose of a merged model with six
// digits and reads it again.
constexpr double kTolerance = 1e-11, kMergedTolerance = 1e-4;

void append(Numbers &numbers, const worlds::Vector3 &v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); }
void append(Numbers &numbers, const ignition::math::Vector3d &v) {
    numbers.insert(numbers.end(), {v.X(), v.Y(), v.Z()});
}
template <class Matrix>
void appendMatrix(Numbers &numbers, const Matrix &matrix) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) numbers.push_back(matrix(i, j));
}
void append(Numbers &numbers, const worlds::Pose &pose) {
    append(numbers, pose.position);
    appendMatrix(numbers, worlds::Matrix3::rotation(pose.rotation));
}
void append(Numbers &numbers, const ignition::math::Pose3d &pose) {
    append(numbers, pose.Pos());
    appendMatrix(numbers, ignition::math::Matrix3d(pose.Rot()));
}

// ---- as the loader reads it

struct ShapeNumbers {
    Numbers operator()(const worlds::Box &box) const { return {1, box.size.x, box.size.y, box.size.z}; }
    Numbers operator()(const worlds::Sphere &sphere) const { return {2, sphere.radius}; }
    Numbers operator()(const worlds::Cylinder &cylinder) const {
        return {3, cylinder.radius, cylinder.length};
    }
    Numbers operator()(const worlds::Capsule &capsule) const { return {4, capsule.radius, capsule.length}; }
    Numbers operator()(const worlds::Plane &plane) const {
        return {5, plane.normal.x, plane.normal.y, plane.normal.z};
    }
    Numbers operator()(const worlds::TriangleMesh &) const { return {6}; }
    Numbers operator()(const worlds::HeightField &field) const { return {7, field.width, field.depth}; }
};

double finite(double limit) { return std::isfinite(limit) ? limit : std::copysign(kNone, limit); }

void add(Facts &facts, const worlds::Physics &physics) {
    Numbers &numbers = facts["physics"];
    append(numbers, physics.gravity);
    numbers.insert(numbers.end(),
                   {physics.stepSize, double(physics.maxContacts), double(physics.iterations), physics.sor,
                    physics.cfm, physics.erp, physics.maxCorrectingSpeed, physics.surfaceLayer});
}

void add(Facts &facts, const worlds::Link &link) {
    Numbers &numbers = facts["link " + link.name];
    append(numbers, link.pose);
    numbers.push_back(link.isStatic);
    if (!link.isStatic) {
        numbers.insert(numbers.end(), {link.mass.mass, double(link.gravity), double(link.kinematic),
                                       double(link.autoDisable)});
        append(numbers, link.mass.center);
        appendMatrix(numbers, link.mass.inertia);
    }
    for (const worlds::Collision &collision : link.collisions) {
        Numbers &shape = facts["collision " + link.name + "::" + collision.name];
        append(shape, collision.pose);
        const Numbers size = std::visit(ShapeNumbers(), collision.shape);
        shape.insert(shape.end(), size.begin(), size.end());
    }
}

void add(Facts &facts, const worlds::WorldDescription &world, const worlds::Joint &joint) {
    const auto name = [&](int link) {
        return link == worlds::Joint::world ? "world" : world.links[link].name;
    };
    Numbers &numbers =
        facts["joint " + joint.name + " from " + name(joint.parent) + " to " + name(joint.child)];
    numbers.push_back(static_cast<double>(joint.type));
    append(numbers, joint.anchor);
    for (const worlds::JointAxis &axis : joint.axes) {
        append(numbers, axis.direction);
        numbers.insert(numbers.end(),
                       {finite(axis.lower), finite(axis.upper), finite(axis.maxForce), finite(axis.maxSpeed),
                        axis.friction, axis.damping, axis.springStiffness, axis.springReference});
    }
}

Facts readByLoader(const std::string &text, const std::string &file) {
    const worlds::LoadOptions options;
    const worlds::ResourceFinder resources(file, {});
    const worlds::Issues issues(options);
    const worlds::Reading reading{resources, issues};
    const worlds::WorldDescription world =
        worlds::readWorld(worlds::readDocument(text, file, reading), reading);
    Facts facts;
    add(facts, world.physics);
    for (const worlds::Link &link : world.links) add(facts, link);
    for (const worlds::Joint &joint : world.joints) add(facts, world, joint);
    return facts;
}

// ---- as libsdformat reads it

ignition::math::Pose3d resolved(const sdf::SemanticPose &semantic, const std::string &frame = {}) {
    ignition::math::Pose3d pose;
    for (const sdf::Error &error : semantic.Resolve(pose, frame)) ADD_FAILURE() << error.Message();
    return pose;
}

Numbers shapeNumbers(const sdf::Geometry &shape) {
    if (const auto *box = shape.BoxShape()) return {1, box->Size().X(), box->Size().Y(), box->Size().Z()};
    if (const auto *sphere = shape.SphereShape()) return {2, sphere->Radius()};
    if (const auto *cylinder = shape.CylinderShape()) return {3, cylinder->Radius(), cylinder->Length()};
    if (const auto *capsule = shape.CapsuleShape()) return {4, capsule->Radius(), capsule->Length()};
    if (const auto *plane = shape.PlaneShape())
        return {5, plane->Normal().X(), plane->Normal().Y(), plane->Normal().Z()};
    if (shape.MeshShape()) return {6};
    return {7, shape.HeightmapShape()->Size().X(), shape.HeightmapShape()->Size().Y()};
}

bool flag(const sdf::ElementPtr &element, const std::string &name, bool otherwise) {
    return element->HasElement(name) ? element->Get<bool>(name) : otherwise;
}

worlds::JointType typeOf(sdf::JointType type) {
    switch (type) {
        case sdf::JointType::REVOLUTE:
        case sdf::JointType::CONTINUOUS:
            return worlds::JointType::Revolute;
        case sdf::JointType::PRISMATIC:
            return worlds::JointType::Prismatic;
        case sdf::JointType::BALL:
            return worlds::JointType::Ball;
        case sdf::JointType::UNIVERSAL:
            return worlds::JointType::Universal;
        case sdf::JointType::REVOLUTE2:
            return worlds::JointType::Revolute2;
        default:
            return worlds::JointType::Fixed;
    }
}

class ByLibrary {
public:
    Facts facts;

    void world(const sdf::World &world) {
        Numbers &numbers = facts["physics"];
        append(numbers, world.Gravity());
        const sdf::Physics &physics = *world.PhysicsDefault();
        numbers.push_back(physics.MaxStepSize());
        const sdf::ElementPtr element = physics.Element(),
                              ode = element ? element->GetElement("ode") : nullptr;
        numbers.push_back(element ? element->Get<double>("max_contacts") : 20);
        const sdf::ElementPtr solver = ode ? ode->GetElement("solver") : nullptr;
        const sdf::ElementPtr constraints = ode ? ode->GetElement("constraints") : nullptr;
        for (const auto &[name, usual] : {std::pair("iters", 50.0), std::pair("sor", 1.3)})
            numbers.push_back(solver ? solver->Get<double>(name, usual).first : usual);
        for (const auto &[name, usual] :
             {std::pair("cfm", 0.0), std::pair("erp", 0.2), std::pair("contact_max_correcting_vel", 100.0),
              std::pair("contact_surface_layer", 0.001)})
            numbers.push_back(constraints ? constraints->Get<double>(name, usual).first : usual);
        for (std::uint64_t i = 0; i < world.ModelCount(); ++i) model(*world.ModelByIndex(i), "", {}, false);
    }

private:
    void model(const sdf::Model &model, const std::string &outer, const ignition::math::Pose3d &outerPose,
               bool isOuterStatic) {
        const std::string name = outer + model.Name() + "::";
        const ignition::math::Pose3d pose = outerPose * resolved(model.SemanticPose());
        const bool isStatic = isOuterStatic || model.Static();
        for (std::uint64_t i = 0; i < model.LinkCount(); ++i)
            link(*model.LinkByIndex(i), model, name, pose, isStatic);
        for (std::uint64_t i = 0; i < model.ModelCount(); ++i)
            this->model(*model.ModelByIndex(i), name, pose, isStatic);
        for (std::uint64_t i = 0; !isStatic && i < model.JointCount(); ++i)
            joint(*model.JointByIndex(i), name, pose);
    }

    void link(const sdf::Link &link, const sdf::Model &model, const std::string &outer,
              const ignition::math::Pose3d &modelPose, bool isStatic) {
        Numbers &numbers = facts["link " + outer + link.Name()];
        append(numbers, modelPose * resolved(link.SemanticPose()));
        numbers.push_back(isStatic);
        if (!isStatic) {
            const ignition::math::Inertiald &inertial = link.Inertial();
            numbers.insert(
                numbers.end(),
                {inertial.MassMatrix().Mass(), double(flag(link.Element(), "gravity", true)),
                 double(flag(link.Element(), "kinematic", false)), double(model.AllowAutoDisable())});
            append(numbers, inertial.Pose().Pos());
            appendMatrix(numbers, inertial.Moi());
        }
        for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
            const sdf::Collision &collision = *link.CollisionByIndex(i);
            Numbers &shape = facts["collision " + outer + link.Name() + "::" + collision.Name()];
            append(shape, resolved(collision.SemanticPose()));
            const Numbers size = shapeNumbers(*collision.Geom());
            shape.insert(shape.end(), size.begin(), size.end());
        }
    }

    void joint(const sdf::Joint &joint, const std::string &outer, const ignition::math::Pose3d &modelPose) {
        std::string parent, child;
        for (const sdf::Error &error : joint.ResolveParentLink(parent)) ADD_FAILURE() << error.Message();
        for (const sdf::Error &error : joint.ResolveChildLink(child)) ADD_FAILURE() << error.Message();
        Numbers &numbers = facts["joint " + outer + joint.Name() + " from " +
                                 (parent == "world" ? parent : outer + parent) + " to " + outer + child];
        numbers.push_back(static_cast<double>(typeOf(joint.Type())));
        append(numbers, (modelPose * resolved(joint.SemanticPose(), "__model__")).Pos());
        for (unsigned i = 0; i < 2; ++i) {
            const sdf::JointAxis *const axis = joint.Axis(i);
            if (!axis) continue;
            ignition::math::Vector3d direction;
            for (const sdf::Error &error : axis->ResolveXyz(direction, "__model__"))
                ADD_FAILURE() << error.Message();
            append(numbers, modelPose.Rot() * direction);
            const auto limit = [](double most) { return most < 0 || most > kNone ? kNone : most; };
            const auto stop = [](double at) { return std::clamp(at, -kNone, kNone); };
            numbers.insert(numbers.end(), {stop(axis->Lower()), stop(axis->Upper()), limit(axis->Effort()),
                                           limit(axis->MaxVelocity()), axis->Friction(), axis->Damping(),
                                           axis->SpringStiffness(), axis->SpringReference()});
        }
    }
};

Facts readByLibrary(const std::string &text, const std::string &file) {
    sdf::Console::Instance()->SetQuiet(true);
    const worlds::ResourceFinder resources(file, {});
    sdf::ParserConfig config;
    config.SetFindCallback([&](const std::string &uri) { return resources.find(uri, file); });
    sdf::Root root;
    for (const sdf::Error &error : root.LoadSdfString(text, config))
        if (error.Code() != sdf::ErrorCode::ATTRIBUTE_INCORRECT_TYPE) ADD_FAILURE() << error.Message();
    ByLibrary library;
    if (root.WorldCount() == 1) library.world(*root.WorldByIndex(0));
    return library.facts;
}

// Returns the largest difference of two numbers; things that only one has are failures.
double compare(const Facts &ours, const Facts &theirs, double tolerance) {
    double largest = 0;
    for (const auto &[name, numbers] : theirs) EXPECT_TRUE(ours.count(name)) << "the loader has no " << name;
    for (const auto &[name, numbers] : ours) {
        const auto found = theirs.find(name);
        if (found == theirs.end() || found->second.size() != numbers.size()) {
            ADD_FAILURE() << (found == theirs.end() ? "libsdformat has no " : "other numbers of ") << name;
            continue;
        }
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const double other = found->second[i],
                         difference = numbers[i] == other ? 0 : std::fabs(numbers[i] - other);
            EXPECT_LT(difference, tolerance) << "number " << i << " of " << name;
            largest = std::max(largest, difference);
        }
    }
    return largest;
}

double compareFile(const std::string &file) {
    const std::string text = worlds::readTextFile(file);
    return compare(readByLoader(text, file), readByLibrary(text, file), kTolerance);
}

TEST(SdformatOracle, WorldsOfTheRepository) {
    double largest = 0;
    for (const std::string &name : worlds::availableWorlds()) {
        SCOPED_TRACE(name);
        largest = std::max(largest, compareFile(worlds::findWorld(name)));
    }
    std::cout << "largest difference: " << largest << '\n';
}

class DrawnWorlds : public testing::TestWithParam<int> {};

TEST_P(DrawnWorlds, AreReadAlike) {
    const int version = GetParam();
    double largest = 0, largestMerged = 0;
    std::size_t things = 0;
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const TestFolder folder("sdformat_oracle");
        const std::string file = folder.path("test.sdf"),
                          text = small_world::randomSdf(seed, version, folder);
        SCOPED_TRACE("seed " + std::to_string(seed) + ":\n" + text);
        try {
            const Facts ours = readByLoader(text, file);
            things += ours.size();
            const bool isMerged = text.find("merge=") != std::string::npos;
            const double difference =
                compare(ours, readByLibrary(text, file), isMerged ? kMergedTolerance : kTolerance);
            (isMerged ? largestMerged : largest) = std::max(isMerged ? largestMerged : largest, difference);
        } catch (const worlds::LoadError &error) {
            ADD_FAILURE() << error.what();
        }
        if (HasFailure()) break;
    }
    EXPECT_GT(things, 300u);
    std::cout << things << " things, largest difference: " << largest << ", with merged models "
              << largestMerged << '\n';
}

INSTANTIATE_TEST_SUITE_P(OfVersion, DrawnWorlds, testing::Range(4, 10));

}  // namespace

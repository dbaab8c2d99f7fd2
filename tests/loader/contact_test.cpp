// Which contacts become joints.
#include "small_world.h"

#include "loader/scene/contact_rules.h"

namespace {

using namespace small_world;

std::vector<dContact> contactsOf(const std::vector<double> &depths) {
    std::vector<dContact> contacts(depths.size());
    for (std::size_t i = 0; i < depths.size(); ++i) contacts[i].geom.depth = depths[i];
    return contacts;
}

TEST(DeepestContacts, AreKeptInTheirOrder) {
    const auto contacts = contactsOf({1, 5, 2, 4, 3});
    EXPECT_EQ(worlds::deepestContacts(contacts, 5, 3), (std::vector<int>{1, 3, 4}));
    EXPECT_EQ(worlds::deepestContacts(contacts, 5, 5), (std::vector<int>{0, 1, 2, 3, 4}));
    EXPECT_EQ(worlds::deepestContacts(contacts, 3, 2), (std::vector<int>{1, 2}));
}

TEST(DeepestContacts, TakeTheEarlierOfEquals) {
    EXPECT_EQ(worlds::deepestContacts(contactsOf({1, 2, 2, 2, 1}), 5, 2), (std::vector<int>{1, 2}));
    EXPECT_EQ(worlds::deepestContacts(contactsOf({1, 1, 1}), 3, 2), (std::vector<int>{0, 1}));
}

std::size_t contactsOfABoxOnTheFloor(const std::string &limitOfBox, const std::string &limitOfWorld) {
    const auto scene = load(
        worldWith("<physics type=\"ode\"><max_step_size>0.001</max_step_size>" + limitOfWorld + "</physics>",
                  ground + "<model name=\"m\"><pose>0 0 0.0999 0 0 0</pose>" +
                      linkOf1kg("link", "0 0 0 0 0 0",
                                "<collision name=\"shape\">" + limitOfBox + "<geometry>" +
                                    box(0.2, 0.2, 0.2) + "</geometry></collision>") +
                      "</model>"));
    scene->frame();
    return scene->contactCount();
}

TEST(Contacts, AreLimitedByWorldAndShape) {
    EXPECT_EQ(contactsOfABoxOnTheFloor("", ""), 4u);
    EXPECT_EQ(contactsOfABoxOnTheFloor("", "<max_contacts>3</max_contacts>"), 3u);
    EXPECT_EQ(contactsOfABoxOnTheFloor("<max_contacts>2</max_contacts>", "<max_contacts>3</max_contacts>"),
              2u);
    EXPECT_EQ(contactsOfABoxOnTheFloor("", "<odemt:contact_candidates>1</odemt:contact_candidates>"), 1u);
}

class PairCounter : public scenes::Observer {
public:
    void nearPair(dGeomID, dGeomID) override { ++pairs; }
    void contact(const dContact &) override { ++contacts; }
    int pairs = 0, contacts = 0;
};

TEST(Contacts, AreShownToTheObserver) {
    const auto scene = load(world(ground + model("a", "0 0 0.0999 0 0 0", sphere(0.1)) +
                                  model("b", "0.15 0 0.0999 0 0 0", sphere(0.1))));
    PairCounter watch;
    scene->observe(&watch);
    scene->frame();
    EXPECT_EQ(watch.pairs, 3);
    EXPECT_EQ(watch.contacts, 3);
    EXPECT_EQ(scene->contactCount(), 3u);
}

TEST(Contacts, StaticShapesDoNotMeet) {
    const auto scene = load(world(ground + staticModel("a", "0 0 0 0 0 0", box(1, 1, 1)) +
                                  staticModel("b", "0 0 0 0 0 0", sphere(1))));
    PairCounter watch;
    scene->observe(&watch);
    scene->frame();
    EXPECT_EQ(watch.pairs, 0);
}

// Two overlapping links of one model.
std::size_t contactsWithin(const std::string &inModel, const std::string &inLink,
                           const std::string &joint = "") {
    const std::string shape =
        "<collision name=\"shape\"><geometry>" + sphere(0.1) + "</geometry></collision>";
    const auto scene =
        load(world("<model name=\"m\">" + inModel + linkOf1kg("a", "0 0 0 0 0 0", inLink + shape) +
                   linkOf1kg("b", "0.1 0 0 0 0 0", shape) + joint + "</model>"));
    scene->frame();
    return scene->contactCount();
}

TEST(Contacts, WithinAModelOnlyIfItWantsTo) {
    const std::string selfCollide = "<self_collide>true</self_collide>";
    EXPECT_EQ(contactsWithin("", ""), 0u);
    EXPECT_EQ(contactsWithin(selfCollide, ""), 1u);
    EXPECT_EQ(contactsWithin("", selfCollide), 1u);
    EXPECT_EQ(contactsWithin(selfCollide, "",
                             "<joint name=\"j\" type=\"ball\"><parent>a</parent><child>b</child></joint>"),
              0u);
}

}  // namespace

#include "collision/narrowphase/boxes/dxBoxBox.h"

#include <algorithm>

#include <ode/odemath.h>

#include "threading/dxFloatEnvironment.h"

#include "config.h"
#include "collision_kernel.h"
#include "collision_std.h"
#include "collision_util.h"

// Upstream's function: chooses `chosen` of the points of a polygon, of which `first` is one. The points are x, y.
void cullPoints(int count, dReal *points, int chosen, int first, int *indices);

namespace {

constexpr int kAsksUpstream = -1;

// With CONTACTS_UNIMPORTANT upstream takes the first axis that does not separate the boxes, and does not look at the others.
bool mayAnswer(int flags) {
    static const bool hasKernel = dxHasBoxKernel();
    return hasKernel && (flags & CONTACTS_UNIMPORTANT) == 0 && dxIsPlainFloatMode();
}

void writePoint(const dxBoxContacts &found, int point, dContactGeom &contact) {
    for (int k = 0; k < 3; ++k) contact.pos[k] = found.position[k][point];
    contact.depth = found.depths[point];
}

// Writes as many points as the program wants, of more; the deepest one comes first.
void writeChosen(const dxBoxContacts &found, int wanted, dContactGeom *contacts, int skip) {
    dReal onFace[2 * dxBoxContacts::kMax];
    for (int i = 0; i < 2 * found.count; ++i) onFace[i] = found.onFace[i % 2][i / 2];
    const auto deepest = static_cast<int>(std::max_element(found.depths, found.depths + found.count) - found.depths);
    int chosen[dxBoxContacts::kMax];
    cullPoints(found.count, onFace, wanted, deepest, chosen);
    for (int i = 0; i < wanted; ++i) writePoint(found, chosen[i], *CONTACT(contacts, i * skip));
}

int writePoints(const dxBoxContacts &found, int flags, dContactGeom *contacts, int skip) {
    const int wanted = std::max(flags & NUMC_MASK, 1);
    if (found.count > wanted) {
        writeChosen(found, wanted, contacts, skip);
        return wanted;
    }
    for (int i = 0; i < found.count; ++i) writePoint(found, i, *CONTACT(contacts, i * skip));
    return found.count;
}

}  // namespace

int dxBoxBox(const dxBoxPair &boxes, dReal *normal, dReal &depth, int &code, int flags, dContactGeom *contacts, int skip) {
    dxBoxContacts found;
    if (!mayAnswer(flags) || !dxFindBoxContacts(boxes, found)) return kAsksUpstream;
    if (found.code == 0) return 0;
    std::copy_n(found.normal, 3, normal);
    depth = found.depth;
    if (found.count == 0) return 0;
    code = found.code;
    return writePoints(found, flags, contacts, skip);
}

// Replaces upstream's dCollideBoxBox (ode/seams.cmake), which still answers where the kernel does not, or where one of its assertions may fail.
int dxCollideBoxBox(dxGeom *o1, dxGeom *o2, int flags, dContactGeom *contacts, int skip) {
    const auto upstream = [=] { return dCollideBoxBox(o1, o2, flags, contacts, skip); };
    dxBoxContacts found;
    if (skip < static_cast<int>(sizeof(dContactGeom)) || !mayAnswer(flags)) return upstream();
    const dxPosR &pose1 = *o1->final_posr, &pose2 = *o2->final_posr;
    const dxBoxPair boxes = {{pose1.pos, pose2.pos}, {pose1.R, pose2.R}, {static_cast<dxBox *>(o1)->side, static_cast<dxBox *>(o2)->side}};
    if (!dxFindBoxContacts(boxes, found)) return upstream();
    if (found.code == 0) return 0;
    const int count = writePoints(found, flags, contacts, skip);
    for (int i = 0; i < count; ++i) {
        dContactGeom &contact = *CONTACT(contacts, i * skip);
        for (int k = 0; k < 3; ++k) contact.normal[k] = -found.normal[k];
        contact.g1 = o1;
        contact.g2 = o2;
        contact.side1 = contact.side2 = -1;
    }
    return count;
}

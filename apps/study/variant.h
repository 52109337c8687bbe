#pragma once

#include "apps/study/study_file.h"
#include "core/scene.h"

namespace ringlet {

/// One run of a study: a whole scene, and what is special about it.
struct Variant {
  std::string name;
  std::string folder;                         ///< a name for its folder, no other has it
  std::map<std::string, std::string> values;  ///< of each axis, in words
  Json scene;                                 ///< every default and whole path written out
  std::string refusal;                        ///< not empty: why it cannot run
  double dt = 0;                              ///< s
  int compare_every = 0;                      ///< steps; 0: nothing is compared
};

struct StudyVariants {
  std::vector<Variant> variants;
  std::optional<Variant> reference;
  std::string as_it_stands;  ///< name of the variant that is the scene as it stands; "": none is
};

/// All variants of a study. Those whose scene is refused say why. Throws Error if a scene cannot be
/// read, InvalidInput if time steps do not fit into the study, or two variants have one name.
StudyVariants make_variants(const StudyFile& study, const std::filesystem::path& folder,
                            Registry& registry);

/// A value of an axis in words.
std::string in_words(const Json& value);

}  // namespace ringlet

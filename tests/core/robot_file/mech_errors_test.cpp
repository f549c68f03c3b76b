// Every mistake in a mechanism file is told with its place and with what was expected.
#include "core/robot_file/mech_file.hpp"
#include "tests/core/robot_file/bad_case.hpp"

namespace abstand::robot_file {
namespace mech_errors_test {

class BadMechFile : public ::testing::TestWithParam<BadCase> {};

TEST_P(BadMechFile, IsRejectedWithPosition) {
  expectRefused(GetParam(), "bad.mech", parseMechanism, "expected");
}

INSTANTIATE_TEST_SUITE_P(
    Words, BadMechFile,
    ::testing::Values(BadCase{"empty", "", 0, 0, "no frame"},
                      BadCase{"comments only", "# nothing\n", 0, 0, "no frame"},
                      BadCase{"unknown environment", "# a\n  joints\n", 2, 3, "'joints'"},
                      BadCase{"capitals", "Chain\nframe 1 0 0 0 0\nend_chain\n", 1, 1, "lowercase: chain"},
                      BadCase{"misspelt", "\n\nmaping\n", 3, 1, "did you mean mapping?"},
                      BadCase{"command outside", "frame 1 0 0 0 0\n", 1, 1, "an environment"},
                      BadCase{"end outside", "end_chain\n", 1, 1, "an environment"},
                      BadCase{"word behind environment", "chain 1\n", 1, 7, "'1'"},
                      BadCase{"word behind end", "units\nend_units x\n", 2, 11, "'x'"},
                      BadCase{"no end", "chain\nframe 1 0 0 0 0\n", 1, 1, "end_chain"},
                      BadCase{"wrong end", "chain\nframe 1 0 0 0 0\nend_link\n", 3, 1, "end_chain"},
                      BadCase{"end with a blank", "units\nend units\n", 2, 1, "'end'"},
                      BadCase{"end capital", "units\nEnd_Units\n", 2, 1, "lowercase: end_units"},
                      BadCase{"environment within", "chain\nchain\n", 2, 1, "frame, reference or end_chain"},
                      BadCase{"not printable", "ch\x01in\n", 1, 1, "'ch?in'"},
                      BadCase{"long word",
                              "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx", 1,
                              1, "..."}));

INSTANTIATE_TEST_SUITE_P(
    Units, BadMechFile,
    ::testing::Values(BadCase{"unknown length", "units\nlength feet\nend_units\n", 2, 8,
                              "mm, cm, m or inches"},
                      BadCase{"inch", "units\n length inch\n", 2, 9, "did you mean inches?"},
                      BadCase{"capital", "units\n length MM\n", 2, 9, "lowercase: mm"},
                      BadCase{"unknown angle", "units\nangle deg\n", 2, 7, "degrees or radians"},
                      BadCase{"no value", "units\nlength\n", 2, 7, "found 0 values"},
                      BadCase{"two values", "units\nlength m mm\n", 2, 10, "found 2 values"},
                      BadCase{"length twice", "units\nlength m\nlength m\n", 3, 1, "second"},
                      BadCase{"units twice", "units\nend_units\nunits\nend_units\n", 3, 1, "second"},
                      BadCase{"other command", "units\nmass kg\n", 2, 1, "length, angle or end_units"}));

INSTANTIATE_TEST_SUITE_P(
    Mapping, BadMechFile,
    ::testing::Values(
        BadCase{"frame not there", "mapping\ndof 0 4\nend_mapping\nchain\nframe 1 0 0 0 theta\nend_chain\n",
                2, 7, "a frame that a chain defines"},
        BadCase{"not from zero", "mapping\ndof 1 1\n", 2, 5, "expected 0"},
        BadCase{"gap", "mapping\ndof 0 1\ndof 2 2\n", 3, 5, "expected 1"},
        BadCase{"negative id", "mapping\ndof -1 1\n", 2, 5, "'-1'"},
        BadCase{"frame zero", "mapping\ndof 0 0\n", 2, 7, "'0'"},
        BadCase{"no whole number", "mapping\ndof 0 1.5\n", 2, 7, "'1.5'"},
        BadCase{"one value", "mapping\ndof 0\n", 2, 6, "found 1 value "},
        BadCase{"three values", "mapping\ndof 0 1 0\n", 2, 10, "2 or 4"},
        BadCase{"five values", "mapping\ndof 0 1 0 1 2\n", 2, 13, "2 or 4"},
        BadCase{"offset no number", "mapping\ndof 0 1 x 1\n", 2, 9, "an offset"},
        BadCase{"scale infinite", "mapping\ndof 0 1 0 inf\n", 2, 11, "a scale"},
        BadCase{"scale zero", "mapping\ndof 0 1 0 0\n", 2, 11, "scale 0"},
        BadCase{"scale too large",
                "mapping\ndof 0 1 0 1e7\nend_mapping\nchain\nframe 1 0 0 0 theta\nend_chain\n", 2, 11,
                "1e+07"},
        BadCase{"constant frame", "mapping\ndof 0 1\nend_mapping\nchain\nframe 1 0 0 0 0\nend_chain\n", 2, 7,
                "constant"},
        BadCase{"frame twice",
                "mapping\ndof 0 1\ndof 1 1\nend_mapping\nchain\nframe 1 0 0 0 theta\nend_chain\n", 3, 7,
                "second time"},
        BadCase{"variable left out",
                "mapping\ndof 0 1\nend_mapping\nchain\nframe 1 0 0 0 theta\nframe 2 0 0 d 0\nend_chain\n", 6,
                7, "frame 2"},
        BadCase{"empty mapping", "mapping\nend_mapping\nchain\nframe 1 0 0 0 theta\nend_chain\n", 4, 7,
                "frame 1"},
        BadCase{"mapping twice", "mapping\nend_mapping\nmapping\n", 3, 1, "second"},
        BadCase{"other command", "mapping\nDOF 0 1\n", 2, 1, "lowercase: dof"}));

INSTANTIATE_TEST_SUITE_P(
    Chain, BadMechFile,
    ::testing::Values(
        BadCase{"id twice", "chain\nframe 1 0 0 0 0\nframe 1 0 0 0 0\nend_chain\n", 3, 7, "second time"},
        BadCase{"id twice in two chains",
                "chain\nframe 1 0 0 0 0\nend_chain\nchain\nframe 1 0 0 0 0\nend_chain\n", 5, 7,
                "second time"},
        BadCase{"id zero", "chain\nframe 0 0 0 0 0\n", 2, 7, "'0'"},
        BadCase{"id negative", "chain\nframe -3 0 0 0 0\n", 2, 7, "'-3'"},
        BadCase{"id huge", "chain\nframe 99999999999 0 0 0 0\n", 2, 7, "'99999999999'"},
        BadCase{"three values", "chain\nframe 1 0 0 0\nend_chain\n", 2, 14, "found 4 values"},
        BadCase{"six values", "chain\nframe 1 0 0 0 0 0\nend_chain\n", 2, 17, "found 6 values"},
        BadCase{"nan", "chain\nframe 1 nan 0 0 0\n", 2, 9, "'nan'"},
        BadCase{"infinite", "chain\nframe 1 0 inf 0 0\n", 2, 11, "alpha"},
        BadCase{"overflow", "chain\nframe 1 1e999 0 0 0\n", 2, 9, "finite"},
        BadCase{"too long", "units\nlength cm\nend_units\nchain\nframe 1 1e9 0 0 0\nend_chain\n", 5, 9,
                "1e+08"},
        BadCase{"trailing letter", "chain\nframe 1 0 90deg 0 0\n", 2, 11, "'90deg'"},
        BadCase{"comma", "chain\nframe 1 0,5 0 0 0\n", 2, 9, "'0,5'"},
        BadCase{"two variables", "chain\nframe 1 0 0 d theta\nend_chain\n", 2, 15, "both variable"},
        BadCase{"theta in d's place", "chain\nframe 1 0 0 theta 0\n", 2, 13, "'theta'"},
        BadCase{"d in theta's place", "chain\nframe 1 0 0 0 d\n", 2, 15, "'d'"},
        BadCase{"a variable", "chain\nframe 1 a 0 0 0\n", 2, 9, "'a'"},
        BadCase{"capital theta", "chain\nframe 1 0 0 0 Theta\n", 2, 15, "lowercase: theta"},
        BadCase{"misspelt theta", "chain\nframe 1 0 0 0 teta\n", 2, 15, "did you mean theta?"},
        BadCase{"unknown reference", "chain\nreference 9\nframe 1 0 0 0 theta\nend_chain\n", 2, 11, "'9'"},
        BadCase{"own frame as reference", "chain\nreference 1\nframe 1 0 0 0 theta\nend_chain\n", 2, 11,
                "'1'"},
        BadCase{"later frame as reference",
                "chain\nreference 2\nframe 1 0 0 0 0\nend_chain\nchain\nframe 2 0 0 0 0\nend_chain\n", 2, 11,
                "'2'"},
        BadCase{"reference not first", "chain\nframe 1 0 0 0 0\nreference 0\n", 3, 1, "before the frames"},
        BadCase{"two references", "chain\nreference 0\nreference 0\n", 3, 1, "once"},
        BadCase{"reference without value", "chain\nreference\n", 2, 10, "found 0 values"},
        BadCase{"no frame", "# a\nchain\nend_chain\n", 2, 1, "without a frame"},
        BadCase{"other command", "chain\nframes 1 0 0 0 0\n", 2, 1, "did you mean frame?"}));

#define LINK "chain\nframe 1 0 0 0 theta\nend_chain\nlink\n"
INSTANTIATE_TEST_SUITE_P(
    Link, BadMechFile,
    ::testing::Values(
        BadCase{"unknown frame", LINK "id 2\ncenter 1 0 0 0 0 1 0 0 0 0 1 0\nend_link\n", 5, 4, "frame 2"},
        BadCase{"no id", LINK "center 1 0 0 0 0 1 0 0 0 0 1 0\nend_link\n", 4, 1, "without 'id'"},
        BadCase{"no center", LINK "id 1\nend_link\n", 4, 1, "without 'center'"},
        BadCase{"id twice", LINK "id 1\nid 1\n", 6, 1, "second 'id'"},
        BadCase{"center twice", LINK "center 1 0 0 0 0 1 0 0 0 0 1 0\ncenter 1 0 0 0 0 1 0 0 0 0 1 0\n", 6, 1,
                "second 'center'"},
        BadCase{"eleven numbers", LINK "id 1\ncenter 1 0 0 0 0 1 0 0 0 0 1\n", 6, 29, "found 11 values"},
        BadCase{"nan", LINK "id 1\ncenter 1 0 0 nan 0 1 0 0 0 0 1 0\n", 6, 14, "'nan'"},
        BadCase{"scaled", LINK "id 1\ncenter 2 0 0 0 0 2 0 0 0 0 2 0\nend_link\n", 6, 8, "no pose"},
        BadCase{"mirrored", LINK "id 1\ncenter 1 0 0 0 0 1 0 0 0 0 -1 0\nend_link\n", 6, 8, "no pose"},
        BadCase{"sheared", LINK "id 1\ncenter 1 0.1 0 0 0 1 0 0 0 0 1 0\nend_link\n", 6, 8, "no pose"},
        BadCase{"too far", LINK "id 1\ncenter 1 0 0 1e7 0 1 0 0 0 0 1 0\nend_link\n", 6, 14, "1e+07"},
        BadCase{"link twice",
                LINK "id 1\ncenter 1 0 0 0 0 1 0 0 0 0 1 0\nend_link\nlink\nid 1\n"
                     "center 1 0 0 0 0 1 0 0 0 0 1 0\nend_link\n",
                9, 4, "second link"},
        BadCase{"centre", LINK "id 1\ncentre 1 0 0 0 0 1 0 0 0 0 1 0\n", 6, 1, "did you mean center?"}));
#undef LINK

}  // namespace mech_errors_test
}  // namespace abstand::robot_file

// The words for the parts of a body.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rigless::detail {

// What a word means before the other names are looked at. Bones of the Acclaim vocabulary and words that mean one thing
// here and another there have a sense of their own.
enum class NameSense : std::int32_t {
  none,
  hips,
  hip,   // hips, or with a side the top of the thigh
  root,  // hips if nothing else is
  spine,
  upper_back,
  chest,
  neck,
  head,
  nose,  // head if nothing else is
  collar,
  shoulder,
  upper_arm,
  humerus,
  arm,
  lower_arm,
  radius,
  hand,
  finger,
  upper_leg,
  femur,
  hip_joint,
  leg,
  lower_leg,
  tibia,
  ankle,
  foot,
  toe,
  big_toe,  // toe if nothing else is
  helper    // moves with a part, but is none
};

struct SenseWords {
  NameSense sense;
  std::string_view words;  // in small letters, without accents and inner spaces
};

inline constexpr SenseWords sense_words[] = {
    {NameSense::hips,
     " hips pelvis hipcenter hipscenter centerhip midhip spinebase lowertorso torsolower lowerbody becken bassin "
     "bacino "
     "bacia таз 骨盆 盆骨 骨盤 臀部 下半身 腰 センター 골반 엉덩이 "},
    {NameSense::hip, " hip hufte hanche hanches cadera caderas anca "},
    {NameSense::root, " root center centre cog com centerofmass centerofgravity "},
    {NameSense::spine,
     " spine back lowerback torso abdomen abdomenlower abdomenupper lowerabdomen upperabdomen waist belly stomach "
     "lumbar "
     "spinemid midspine spinelower spineupper spinenavel spinenaval spinetwist l1 l2 l3 l4 l5 t9 t10 t11 t12 "
     "wirbelsaule ruckgrat rucken bauch colonne colonnevertebrale dos ventre schiena columna espina espalda colonna "
     "coluna "
     "позвоночник спина живот 上半身 脊椎 脊柱 背骨 腰部 腰椎 척추 허리 "},
    {NameSense::upper_back, " upperback backupper "},
    {NameSense::chest,
     " chest upperchest chestupper chestlower lowerchest thorax ribcage ribs uppertorso torsoupper spineshoulder "
     "spinechest shouldercenter centershoulder sternum t1 t2 t3 t4 t5 t6 t7 t8 brust brustkorb poitrine torse pecho "
     "torax "
     "petto torace peito грудь 胸 胸部 胸腔 가슴 "},
    {NameSense::neck,
     " neck lowerneck upperneck necklower neckupper neckbase necktwist hals nacken cou cuello collo pescoco шея 首 颈 "
     "颈部 "
     "頸 脖子 목 "},
    {NameSense::head, " head kopf tete cabeza testa cabeca голова 頭 头 头部 머리 "},
    {NameSense::nose, " nose skull "},
    {NameSense::collar,
     " collar collarbone clavicle clav clavicula scapula shoulderblade schlusselbein schluesselbein clavicule "
     "clavicola "
     "ключица лопатка 肩 锁骨 鎖骨 쇄골 "},
    {NameSense::shoulder, " shoulder shoulders schulter epaule hombro spalla ombro 肩膀 어깨 "},
    {NameSense::upper_arm,
     " upperarm armupper uparm uarm shldr oberarm bras brazo braccio braco плечо 腕 上臂 上腕 大臂 위팔 상완 "},
    {NameSense::humerus, " humerus "},
    {NameSense::arm, " arm рука 팔 "},
    {NameSense::lower_arm,
     " forearm lowerarm armlower lowarm loarm elbow ulna unterarm ellbogen ellenbogen avantbras coude antebrazo codo "
     "avambraccio gomito antebraco cotovelo предплечье локоть ひじ 肘 前臂 小臂 前腕 手肘 아래팔 전완 팔꿈치 "},
    {NameSense::radius, " radius "},
    {NameSense::hand,
     " hand wrist handgelenk main poignet mano muneca polso mao pulso кисть запястье 手首 手 手腕 手部 손 손목 "},
    {NameSense::finger,
     " finger fingers thumb index ring pinky pinkie little metacarpal metacarpals carpal carpals palm handtip knuckle "
     "knuckles "
     "daumen doigt doigts pouce dedo pulgar dito палец пальцы 손가락 "},
    {NameSense::upper_leg,
     " upleg upperleg legupper uleg thigh oberschenkel cuisse muslo coscia coxa бедро 大腿 太もも もも 股関節 허벅지 "},
    {NameSense::femur, " femur "},
    {NameSense::hip_joint, " hipjoint "},
    {NameSense::leg, " leg bein jambe pierna gamba perna нога 足 다리 "},
    {NameSense::lower_leg,
     " knee shin calf lowleg lowerleg leglower loleg shank unterschenkel knie wade genou mollet rodilla pantorrilla "
     "espinilla ginocchio polpaccio joelho canela голень колено ひざ 膝 すね 脛 小腿 膝盖 下腿 종아리 무릎 정강이 "},
    {NameSense::tibia, " tibia "},
    {NameSense::ankle,
     " ankle knochel fussgelenk cheville tobillo caviglia tornozelo щиколотка лодыжка 足首 足踝 脚踝 脚腕 발목 "},
    {NameSense::foot, " foot feet fuss pied pie piede pe стопа ступня 脚 足部 발 "},
    {NameSense::toe,
     " toe toes toebase ball toeball football ballfoot footindex foottoe zehe zehen orteil orteils dedospie "
     "dedosdelpie "
     "punta носок つま先 足先 脚趾 脚尖 足尖 발가락 발끝 "},
    {NameSense::big_toe, " bigtoe toebig hallux "},
    {NameSense::helper,
     " ik fk pole target ctrl control controller helper prop weapon twist roll aim attach muscle cloth skirt hair tail "
     "sword "
     "breast "
     "socket dummy "},
};

// Say nothing of the part, wherever they stand.
inline constexpr std::string_view noise_words =
    " joint jnt jt bone bn bind skin sk def org bip biped mixamorig valvebiped rig skel drv armature character char j "
    "b c m x "
    "bend "
    "stretch deform skeleton ";
inline constexpr std::string_view end_words = " end nub site endsite tip top eff effector leaf ";
inline constexpr std::string_view left_words =
    " l left lt lft links linke linker linkes gauche izq izquierda izquierdo esquerda esquerdo sinistra sinistro sx "
    "левая "
    "левое левый лев л 左 왼쪽 왼 ";
inline constexpr std::string_view right_words =
    " r right rt rgt rechts rechte rechter rechtes droite droit der derecha derecho direita direito destra destro dx "
    "правая правое правый прав п 右 오른쪽 오른 ";

inline bool among(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != words.npos && !word.empty(); at = words.find(word, at + 1)) {
    if (at > 0 && words[at - 1] == ' ' && words[at + word.size()] == ' ') return true;
  }
  return false;
}

// By the whole word. Does not allocate.
inline NameSense sense_of(std::string_view word) {
  for (const SenseWords& entry : sense_words) {
    if (among(entry.words, word)) return entry.sense;
  }
  return NameSense::none;
}

}  // namespace rigless::detail

# Ce que dit Sightline, en français : écrans, erreurs, notes, rapport et ligne de commande. La source est en.ftl, à côté,
# dont ce fichier a les clés, les valeurs et les parties marquées, dans le même ordre.

## Mots du domaine : les cibles, et où pointer chacune

target-roof = Toit
target-driver_eye = Œil du conducteur
target-taillight = Feu arrière
target-headlight = Projecteur
target-other = Autre
target-noun-roof = toit
target-noun-driver_eye = œil du conducteur
target-noun-taillight = feu arrière
target-noun-headlight = projecteur
target-noun-other = autre
target-hint-roof = le bord proche du toit, là où il est le plus haut
target-hint-driver_eye = l’œil du conducteur
target-hint-taillight = le bord inférieur de la plage éclairante du feu arrière
target-hint-headlight = le bord inférieur du projecteur
target-hint-other = le point dont vous voulez la hauteur

not-visible-hidden = masqué par un autre véhicule
not-visible-glare = éblouissement
not-visible-too_dark = trop sombre
not-visible-outside = hors de l’image
not-visible-own_body = masqué par le véhicule lui-même
not-visible-no_driver = aucun conducteur visible
direction-right = vers la droite
direction-left = vers la gauche
side-near = côté proche
side-far = côté éloigné
inset-near-edge = bord proche
inset-crown = sommet
inset-roof_car = Toit, voitures
inset-roof_van = Toit, fourgons
inset-roof_box = Toit, camions et bus
inset-roof_unknown = Toit, sans classe
inset-driver_eye_near = Œil du conducteur, côté proche
inset-driver_eye_far = Œil du conducteur, côté éloigné

## Mots du domaine : comment on circule sur un site

traffic-title = Circulation et caméra
traffic-help = Avec le sens de chaque véhicule, ces réglages déterminent si le conducteur est assis du côté de la caméra (proche) ou du côté opposé (éloigné). Sans eux, aucune hauteur d’œil ne peut être calculée.
traffic-not-said = Non indiqué
traffic-side = Circulation
traffic-right = à droite
traffic-left = à gauche
traffic-steering = Volant, en général
wheel-left = à gauche
wheel-right = à droite
traffic-camera = Position de la caméra
place-title = Lieu et route
place-latitude = Latitude (WGS84)
place-longitude = Longitude
place-coordinates-problem = Saisissez des degrés décimaux, par exemple 49.44315 et 1.09932. Sud et ouest sont négatifs.
place-road = Type de route
place-roads = autoroute; route à chaussées séparées; route bidirectionnelle, rase campagne; artère urbaine; rue; voie de desserte
place-lane = Voie mesurée
place-lanes = voie 1, près de l’accotement; voie 2; les deux voies; toutes les voies d’un sens
place-travel = Sens de circulation
place-travel-example = vers Rouen, direction nord
place-limit = Vitesse limite
place-limit-is = limitée à { $limit }
place-limit-problem = Saisissez la vitesse limite, un nombre de { $unit }.
place-lamps = Éclairage public
place-lamps-present = présent
place-lamps-none = absent
place-lamps-are = { $lamps ->
    [present] éclairage public
   *[none] pas d’éclairage public
}
place-not-said = Non indiqué
place-zone = Fuseau horaire
place-zone-hint = Par exemple Europe/Paris. Proposé pour chaque enregistrement.
camera-verge = sur l’accotement
camera-median = sur le terre-plein central

asked-title = Cibles à mesurer
asked-help = Un véhicule est mesuré quand chacune de ces cibles est mesurée ou déclarée non visible.
asked-none = Choisissez au moins une cible de jour et une en faible luminosité.

## Mots du domaine : états des véhicules, mesures, enregistrements, tâches, étalonnages, personnes

state-to_do = à faire
state-partial = mesuré en partie
state-measured = mesuré
state-not_visible = non visible
state-out_of_sample = hors échantillon
state-discarded = écarté
state-to_review = à vérifier
state-accepted = validé
state-fixed = corrigé
state-rejected = rejeté
state-reopened = rouvert
state-withdrawn = retiré
state-not_measurable = non mesurable
state-done = terminé
state-next = à suivre
state-begun = en cours
state-waiting = en attente
state-ingesting = import en cours
state-ready = prêt
state-failed = échec
state-queued = en attente
state-running = en cours
state-cancelled = annulé
state-trusted = fiable
state-not_trusted = non fiable
state-used = utilisée
state-left_out = exclue
state-active = actif
state-inactive = désactivé

## Mots du domaine : la luminosité et les types de véhicules

lighting-daytime = De jour
lighting-low_light = Faible luminosité
lighting-noun-daytime = de jour
lighting-noun-low_light = faible luminosité
category-hatchback = Voiture à hayon
category-saloon = Berline
category-estate = Break
category-suv = SUV
category-multi_purpose = Monospace
category-pickup = Pick-up
category-van = Fourgon
category-lorry = Camion
category-tractor_unit = Tracteur routier
category-bus = Bus ou autocar
category-recreational_vehicle = Camping-car
category-trailer = Remorque ou caravane
category-motorcycle = Motocyclette
category-other = Autre

## Groupes de classes de véhicules

class-set-passenger_cars = Voitures particulières
class-set-light_trucks = Utilitaires légers et monospaces
class-set-heavy = Poids lourds
class-set-none = aucun groupe
class-choice = Classes
discarded-no_vehicle = écarté : pas un véhicule
discarded-twice = écarté : trouvé deux fois
discarded-cut_off = écarté : coupé par l’enregistrement
discarded-stopped = écarté : à l’arrêt ou en train de tourner
discarded-other = écarté : autre motif (voir les notes)
sample-title = Échantillon
sample-edit = Modifier l’échantillon
sample-dialog = Passages à mesurer
sample-method = Passages
sample-method-help = La règle suit le numéro du passage : un passage trouvé plus tard ne change pas la sélection des autres. Les passages non retenus sont marqués « hors échantillon ».
sample-every = tous les passages
sample-nth = un passage sur n
sample-share = une part aléatoire, tirée avec une graine
sample-step = n
sample-step-problem = Saisissez un nombre entier de 2 à 1000.
sample-start = Premier numéro
sample-start-problem = Saisissez un nombre entier de 1 à n.
sample-share-percent = Part
sample-share-problem = Saisissez plus de 0 et au plus 100 %.
sample-seed = Graine
sample-seed-problem = Saisissez un nombre entier.
sample-free = Véhicules libres : temps intervéhiculaire minimal
sample-free-help = Par sens, du début d’un passage au début du suivant. Vide : tous les véhicules. 5 s est usuel.
sample-free-problem = Saisissez des secondes, plus de 0 et au plus 60.
sample-quotas = Quotas
sample-quotas-help = Nombre de véhicules voulus de chaque type. Vide : pas de quota. L’avancement s’affiche à côté des passages pendant la mesure.
sample-quota-problem = Saisissez un nombre entier, 1 ou plus.
sample-quota = { NUMBER($measured) } sur { NUMBER($wanted) }
sample-any-class = toutes classes
sample-response = Bilan des passages
sample-lighting = Luminosité
sample-of = Véhicules ou cible
sample-passes = Passages
sample-discarded = Écartés
sample-out = Hors éch.
sample-measured = Mesurés
sample-unseen = Non visibles
sample-outside = { $counts ->
    [yes] { $count ->
        [one] { NUMBER($count) } passage a été mesuré bien qu’il soit hors échantillon, et compte dans les résultats.
       *[other] { NUMBER($count) } passages ont été mesurés bien qu’ils soient hors échantillon, et comptent dans les résultats.
    }
   *[no] { $count ->
        [one] { NUMBER($count) } passage a été mesuré hors échantillon et ne compte pas dans les résultats.
       *[other] { NUMBER($count) } passages ont été mesurés hors échantillon et ne comptent pas dans les résultats.
    }
}
sample-outside-counts = Les hauteurs mesurées hors échantillon comptent dans les résultats
sample-outside-counts-help = En général non : ces véhicules n’ont pas été choisis par la règle d’échantillonnage. Vaut pour chaque page, archive, rapport et étude.
sample-open = À faire
sample-rate = Taux de réponse
sample-all = Toutes
sample-unknown = inconnue
sample-vehicles = Tous les véhicules
sample-help = Taux de réponse : passages mesurés sur passages de l’échantillon, avec son intervalle exact à 95 %. S’il diffère entre groupes, les véhicules mesurés peuvent ne pas représenter le trafic.
sample-rule = { $method ->
    [nth] Un passage sur { NUMBER($step) } est à mesurer, à partir du numéro { NUMBER($start) }.
    [share] Une part aléatoire de { $share } % des passages est à mesurer (graine { $seed }).
   *[every] Tous les passages sont à mesurer.
}
sample-rule-free = Seulement les véhicules dont le temps intervéhiculaire est d’au moins { $seconds } s.
class-choice-any = toutes les classes
class-choice-help = Groupes et classes de véhicules à retenir. Aucun choix : tous.
class-choice-sets = Groupes
class-choice-classes = Classes
checklist-all = Tout
classes-open = Classes
classes-title = Classes de véhicules
classes-help = Les groupes servent à filtrer statistiques, quotas et archives ; l’archive nomme aussi les classes réglementaires. Une modification vaut aussi pour les mesures existantes, car le groupe d’un véhicule découle de sa classe.
classes-class = Classe
classes-set = Groupe
classes-set-of = Groupe de la classe { $category }
classes-eu = UE
classes-eu-of = Classes UE de la classe { $category }
classes-eu-problem = Saisissez des classes de l’UE : L, M1 à M3, N1 à N3, O1 à O4 ou T.
classes-fhwa = FHWA
classes-fhwa-of = Classes FHWA de la classe { $category }
classes-fhwa-problem = Saisissez des numéros de 1 à 13, par exemple « 5 6 7 » ou « 8-13 ».

## Rôles des personnes

role-viewer = Lecteur
role-operator = Opérateur
role-reviewer = Vérificateur
role-admin = Administrateur
role-manager = Gestionnaire

## Pages : leurs noms dans le menu latéral, le titre de la fenêtre et les liens

page-sign-in = Se connecter
page-surveys = Relevés
page-survey = Vue d’ensemble
page-planning = Préparer le site
page-camera = Caméra
page-recordings = Enregistrements
page-pose = Route
page-measure = Mesure
page-checks = Contrôles
page-review = Vérification
page-lots = Lots
page-repeats = Répétabilité
page-click-again = Repointer
page-scans = Balayages
page-scan-results = Mouvement
page-scan = Balayage
page-live = En direct
page-export = Archive
page-statistics = Résultats
page-sight-distance = Distance de visibilité
page-studies = Études
page-study = Étude
page-catalogue = Catalogue
page-audit = Audit
page-history = Historique
page-settings = Paramètres
page-people = Utilisateurs
page-jobs = Tâches
page-system = Système
page-account = Compte
page-guide = Guide

## Commandes : boutons, menus et liste des touches

command-help = Afficher les raccourcis clavier
command-frameNext = Image suivante
command-framePrevious = Image précédente
command-frameNextTen = Avancer de dix images
command-framePreviousTen = Reculer de dix images
command-secondNext = Avancer d’une seconde
command-secondPrevious = Reculer d’une seconde
command-frameFirst = Première image
command-frameLast = Dernière image
command-frameGo = Aller à une image
command-play = Lire ou mettre en pause
command-loupe = Loupe (maintenir la touche)
command-loupeToggle = Afficher ou masquer la loupe
command-linesToggle = Afficher ou masquer les lignes
command-brightToggle = Éclaircir l’image (affichage seulement)
command-cursor = Afficher ou masquer le curseur au clavier
command-place = Placer le point au curseur
command-zoomIn = Agrandir
command-zoomOut = Réduire
command-zoomFit = Ajuster l’image
command-passNext = Passage suivant
command-passPrevious = Passage précédent
command-target1 = Cible : toit
command-target2 = Cible : œil du conducteur
command-target3 = Cible : feu arrière
command-target4 = Cible : projecteur
command-target5 = Cible : autre
command-notVisible = Déclarer la cible non visible
command-newContact = Nouveau point de contact
command-secondFrame = Ajouter une deuxième image
command-followPass = Suivre sur le passage
command-proposeContact = Proposer le contact du pneu sous le pointeur
command-driverSide = Changer le côté du conducteur (proche ou éloigné)
command-selectNext = Point suivant
command-bestFrame = Meilleure image du passage
command-record = Aller à la marque et au modèle
command-recentModel1 = Modèle récent 1
command-recentModel2 = Modèle récent 2
command-recentModel3 = Modèle récent 3
command-recentModel4 = Modèle récent 4
command-whichModel = Aller aux modèles qui conviennent
command-passBegin = Marquer la première image d’un passage ou de la mire
command-passEnd = Marquer la dernière image d’un passage ou de la mire
command-passSplit = Scinder le passage avant cette image
command-passJoin = Fusionner le passage avec le suivant
command-passDiscard = Écarter le passage
command-confirmNext = Passage inachevé suivant
command-undo = Annuler
command-redo = Rétablir
command-remove = Retirer la mesure sélectionnée
command-cancel = Désélectionner ou abandonner
command-nudgeLeft = Déplacer le point de 1 px à gauche
command-nudgeRight = Déplacer le point de 1 px à droite
command-nudgeUp = Déplacer le point de 1 px vers le haut
command-nudgeDown = Déplacer le point de 1 px vers le bas
command-nudgeLeftFar = Déplacer le point de 10 px à gauche
command-nudgeRightFar = Déplacer le point de 10 px à droite
command-nudgeUpFar = Déplacer le point de 10 px vers le haut
command-nudgeDownFar = Déplacer le point de 10 px vers le bas
command-nudgeLeftFine = Déplacer le point de 0,1 px à gauche
command-nudgeRightFine = Déplacer le point de 0,1 px à droite
command-nudgeUpFine = Déplacer le point de 0,1 px vers le haut
command-nudgeDownFine = Déplacer le point de 0,1 px vers le bas
command-scanFit = Ajuster le véhicule à la fenêtre
command-scanTaller = Étirer verticalement
command-scanFlatter = Comprimer verticalement
command-scanWheels = Pointer les deux roues pour l’empattement
command-scanNew = Ajouter un véhicule par son avant et son arrière
command-scanHeight = Mesurer des hauteurs par contact et cible
command-scanRod = Étalonner la hauteur avec un jalon
command-reviewAccept = Valider
command-reviewReject = Rejeter
command-reviewFix = Corriger
command-reviewNext = Mesure suivante
command-reviewPrevious = Mesure précédente
command-reviewReason1 = Motif 1 de rejet
command-reviewReason2 = Motif 2 de rejet
command-reviewReason3 = Motif 3 de rejet
command-reviewReason4 = Motif 4 de rejet
command-reviewReason5 = Motif 5 de rejet
command-reviewReason6 = Motif 6 de rejet

## Touches, telles qu’elles sont dessinées

key-Ctrl = Ctrl
key-Alt = Alt
key-Shift = Maj
key-Space = Espace
key-Enter = Entrée
key-Tab = Tab
key-Backspace = Retour arr.
key-Home = Début
key-End = Fin
key-Delete = Suppr
key-Escape = Échap
key-PageUp = Pg préc.
key-PageDown = Pg suiv.

## Où les touches agissent

scope-anywhere = Partout
scope-frames = Images
scope-measure = Mesure
scope-point = Un point sélectionné
scope-scan = Balayage
scope-review = Vérification

## Heures, longueurs, et ce qui a mal tourné

table-actions = Actions
time-just-now = à l’instant
time-minutes-ago = il y a { $minutes } min
time-today = aujourd’hui { $time }
length-problem = Saisissez une longueur, par exemple { $example }.
problem-server = Erreur du serveur (code { $status }). Réessayez. Si l’erreur persiste, prévenez votre administrateur.
problem-refused = Le serveur a refusé cette demande (code { $status }).
problem-stopped = L’opération a été arrêtée.
problem-page = Un problème est survenu dans cette page. Rechargez-la ; s’il se reproduit, prévenez votre administrateur.
problem-offline = Le serveur est injoignable.
problem-unreachable = Le serveur était injoignable : ceci n’a pas été enregistré. Vérifiez la connexion et réessayez.
problem-unreadable = La réponse du serveur n’a pas pu être lue : on ne sait pas si ceci a été enregistré. Réessayez.
keys-reserved = Le navigateur se réserve { $chord } ; choisissez une autre touche.

## Adresses de ce qui n’existe pas

address-elsewhere = { $what ->
    [vehicle] Le véhicule de cette adresse n’est pas dans ce relevé, ou a été supprimé.
    [measurement] La mesure de cette adresse n’est pas dans ce relevé, ou a été retirée.
    [recording] L’enregistrement de cette adresse n’est pas dans ce relevé, ou ne peut pas être affiché.
    [camera] La caméra de cette adresse n’est pas dans ce relevé ; une autre est affichée.
   *[scan] Le balayage de cette adresse n’est pas dans ce relevé.
}

## Composants : avancement, annulation

loading = Chargement : { $what }…
job-queued = En attente
job-named = { $job } : { $words }
undo-step = Annuler : { $step }
undo-nothing = Rien à annuler
redo-step = Rétablir : { $step }
redo-nothing = Rien à rétablir
undo-done = Annulé : { $step }.
redo-done = Rétabli : { $step }.

## Guide

guide-pages = Pages du guide
guide-loading = guide
guide-page-first-survey = Premier relevé
guide-page-field-protocol = Protocole de terrain
guide-page-operator = Opérateur
guide-page-reviewer = Vérificateur
guide-page-standards-engineer = Ingénieur de normalisation
guide-page-administrator = Administrateur
guide-page-access = Qui peut faire quoi
guide-page-studies = Études
guide-page-CONVENTIONS = Méthode
guide-page-formats = Formats
guide-page-glossary = Glossaire

## Tâches du serveur, relancées

jobs-only-failed-again = { $state ->
    [queued] Cette tâche attend encore
    [running] Cette tâche est en cours
   *[done] Cette tâche est terminée
 } ; seule une tâche échouée ou arrêtée peut être relancée.
jobs-restart-elsewhere = Une tâche de ce type ({ $kind }) se relance sur la page de son enregistrement, où ses fichiers sont aussi contrôlés.

## Système : la page des administrateurs

system-lead = L’état actuel de cette installation. Prometheus lit les mêmes valeurs sur un port à part.
system-loading = état du système
system-program = Logiciel et serveur
system-version = Version
system-answered = Ce serveur
system-answered-by = { $host }, processus { $process }
system-database = Base de données
system-database-of = { $kind ->
    [sqlite] SQLite
   *[other] PostgreSQL
  }, { $count ->
    [one] { NUMBER($count) } connexion utilisée
   *[other] { NUMBER($count) } connexions utilisées
  }
system-media = Vidéos et images
system-free = Libre sur le disque
system-memory = Mémoire du serveur
system-unknown = non disponible
system-decoder = Décodeur d’images
system-decoder-none = inactif
system-decoder-runs = processus { $process }
system-waiting = En attente
system-waiting-of = { $reading } en lecture, { $writing } en écriture
system-clock = Horloge
system-clock-back = L’horloge a reculé de { $seconds } s, constaté le { $when }. Synchronisez-la avec un serveur de temps (NTP) ; les heures enregistrées à ce moment peuvent être en désordre.
system-jobs = Tâches
system-checkpoints = Points de contrôle
system-checkpoints-sign = Signer un point de contrôle
system-checkpoints-lead = Un point de contrôle signe la fin de chaque chaîne d’audit. Conservez les fichiers hors de ce serveur : ils révèlent une chaîne coupée ou réécrite plus tard. Chaque archive est signée de la même façon.
system-checkpoints-loading = points de contrôle
system-checkpoints-key = Clé actuelle
system-checkpoints-keys-before = { $count ->
    [one] Elle remplace { NUMBER($count) } clé antérieure, qui l’a signée.
   *[other] Elle remplace { NUMBER($count) } clés antérieures ; chacune a signé la suivante.
  }
system-checkpoints-none = Aucun point de contrôle pour l’instant
system-checkpoints-chains = Chaînes
system-checkpoints-events = Événements
system-checkpoints-root = Racine
system-checkpoints-download = Télécharger
system-checkpoints-download-of = Télécharger le point de contrôle du { $when }
system-licences = Bibliothèques et licences
system-licences-show = Afficher
system-licences-hide = Masquer
system-licences-loading = bibliothèques
system-licences-server = Bibliothèque du serveur
system-licences-pages = Bibliothèque des pages
system-licences-version = Version
system-licences-licence = Licence
system-licences-none = non indiquée

## Tâches : la page

own-name-title = Quel est votre nom ?
own-name-why = Il figure à côté de tout ce que vous mesurez, vérifiez et modifiez.
own-name = Votre nom
jobs-lead = Les tâches longues du serveur : en attente, en cours et terminées.
jobs-loading = tâches
jobs-show = Afficher
jobs-all = Toutes
jobs-none-title = Aucune tâche ici
jobs-none = Les imports de vidéos, détections de passages, poses, étalonnages et archives apparaissent ici.
jobs-kind = { $kind ->
    [ingest] Import d’une vidéo
    [passes] Détection des passages
    [proposals] Proposition de points
    [pose] Pose de la caméra
    [calibrate] Étalonnage
    [drift] Contrôle de stabilité de la caméra
    [export] Archive
    [scan_read] Import de bandes
    [scan_find] Détection de véhicules dans les bandes
    [tidy] Nettoyage des fichiers
    [demonstration] Relevé de démonstration
    [demonstration_study] Étude de démonstration (simulée)
    [study] Étude
    [compute_again] Recalcul des hauteurs
   *[other] Autre tâche
}
jobs-column-what = Tâche
jobs-column-for = Pour
jobs-column-state = État
jobs-column-said = Message
jobs-column-begun = Début
jobs-again = Relancer
jobs-begun-again = La tâche est relancée.

## Application : titres, barre du haut, menu latéral, adresses qui ne mènent nulle part

app-name = Sightline
app-title = { $page } – Sightline
app-title-in-survey = { $page } – { $survey } – Sightline
app-not-found = Page introuvable
app-skip = Aller à la page
app-skip-picture = Aller à l’image
app-to-surveys = Aller aux relevés
app-nothing-here-title = Page introuvable
app-nothing-here = Le lien est peut-être ancien, ou le relevé a été supprimé.
app-not-loaded = Cette page n’a pas pu être chargée, peut-être parce qu’une nouvelle version a été installée ; rechargez-la.
app-where = Page actuelle
app-survey = Relevé
app-other-step = { $page } : aller à une autre étape
app-pages = Pages de Sightline
app-admin = Administration
rail-setup = Préparer
rail-measure = Mesurer
rail-quality = Qualité
rail-results = Résultats
app-keys = Raccourcis clavier
app-work = Étapes du relevé
save-waiting = { NUMBER($count) } à enregistrer
save-pending = enregistrement…
save-failed = dernière modification non enregistrée
save-done = enregistré { $time }
menu-person = { $person } : compte
menu-role = { $role } · Sightline { $version }
menu-theme = Thème
menu-theme-system = Système
menu-theme-light = Clair
menu-theme-dark = Sombre
menu-lengths = Longueurs
menu-lengths-m = Mètres
menu-lengths-ft = Pieds
menu-sign-out = Se déconnecter

## Application : tant que le serveur est injoignable

offline-kept = { $count ->
    [one] { NUMBER($count) } modification est gardée dans ce navigateur et sera enregistrée au retour du serveur.
   *[other] { NUMBER($count) } modifications sont gardées dans ce navigateur et seront enregistrées au retour du serveur.
}
offline-changes = { $count ->
    [one] { NUMBER($count) } modification sera enregistrée au retour du serveur ; gardez cette page ouverte.
   *[other] { NUMBER($count) } modifications seront enregistrées au retour du serveur ; gardez cette page ouverte.
}
offline-next = Prochain essai dans { $seconds } s.
offline-now = Nouvel essai…
offline-try = Essayer maintenant

## Application : ce qui a été refusé, ou modifié entre-temps par quelqu’un d’autre

unsaved-refused = <link>{ $what }</link> : { $problem } Votre saisie : { $mine }.
unsaved-conflict = <link>{ $what }</link> : { $problem } Votre saisie : { $mine }. L’autre saisie : { $theirs }.
unsaved-take = Prendre l’autre
unsaved-keep = Garder la mienne
unsaved-again = Réessayer
unsaved-drop = Abandonner
unsaved-otherwise = Le serveur a enregistré une autre valeur ; vérifiez-la.

## Application : la liste des touches

keys-how = Pour changer une touche, cliquez dessus puis appuyez sur la nouvelle. Les touches sont gardées dans ce navigateur.
keys-usual = Touches par défaut
keys-clash = { $chord } désigne à la fois « { $one } » et « { $other } » ; la première l’emporte.
keys-elsewhere = Sur les autres écrans
keys-wheel = Molette : zoom sous le pointeur. Glisser avec le bouton du milieu, ou Espace tenue : déplacer l’image.
keys-of = { $command } : { $keys }. Changer
keys-change = Changer la touche
keys-press = tapez une touche…

## Mires : le type de mire et ses marqueurs

board-kind = Type de mire
board-checkerboard = Damier
board-charuco = ChArUco
board-dictionary = Dictionnaire
board-marker = Côté du marqueur
board-marker-problem = Indiquez le côté du marqueur noir, par exemple { $example }.
board-marker-too-large = Un marqueur est plus petit que sa case.

## La caméra a-t-elle bougé

drift-title = Stabilité de la caméra
drift-stopped = Le contrôle s’est arrêté.
drift-under-way = Contrôle de la stabilité de la caméra…
drift-not-yet = Stabilité de la caméra non contrôlée.
drift-holds = Pose conservée par { $person } : { $reason }
drift-over-time = Mouvement au cours du temps
drift-again = Contrôler à nouveau
drift-take-back = Annuler la décision
drift-reason = Motif pour conserver la pose
drift-decide = Conserver la pose
drift-look = image { $frame } : { $moved_px } px, { $change }
drift-figure = { $untold ->
    [0] Images comparées à celles de la pose de la caméra : { NUMBER($count) } ; plus grande erreur de hauteur : { $worst } (cible à { $target } de haut, distance { $distance }). Bande grisée : seuil de détection.
   *[other] Images comparées à celles de la pose de la caméra : { NUMBER($count) }, dont { $untold } sans résultat ; plus grande erreur de hauteur : { $worst } (cible à { $target } de haut, distance { $distance }). Bande grisée : seuil de détection.
}

## Figures : téléchargements et repères

figure-as-svg = { $figure } en SVG
figure-as-csv = { $figure } en CSV
figure-read = Lire les valeurs : { $figure }
figure-read-hint = Les touches fléchées déplacent le repère le long de l’axe.
figure-read-value = { $what } : { $value }
figure-no-band = n = { $n }. Aucune bande n’est tracée sous { $least } véhicules : elle couvrirait plus de la moitié de l’axe.
figure-standard = { $standards } { $height } { $unit }

## Véhicules : bilan, historique, catalogue, passages

budget-of-click-target = Pointé de la cible
budget-of-click-contact = Pointé du contact du pneu
budget-of-clicks = Pointés
budget-of-inset = Retrait
budget-of-lens-and-pose = Objectif et pose de la caméra
budget-of-board-lean = Inclinaison de la mire
budget-of-board-roll = Roulis de la mire
budget-of-board-height = Hauteur de la mire
budget-of-square-size = Côté d’une case de la mire
budget-of-board-bow = Planéité de la mire
budget-of-heading = Cap du véhicule
budget-of-row-time = Temps de lecture d’une ligne
budget-of-confirmed-points = Points confirmés
budget-of-drift = Dérive des points suivis
budget-of-baseline = Base
budget-of-clock = Horloge
budget-of-misalignment = Désalignement des caméras
budget-of-fit = Ajustement
budget-of-front = Avant
budget-of-rear = Arrière
# of earlier versions, both together
budget-of-boundaries = Bornes
budget-of-front-and-rear = Avant et arrière
budget-of-regression = Régression
budget-of-following = Suivi
budget-of-frame-times = Instants des images
budget-of-depth-of-what-is-followed = Profondeur du point suivi
budget-of-seen-from-another-side = Changement d’angle de vue
budget-of-pose-of-the-line-camera = Pose de la caméra linéaire
budget-title = Bilan d’incertitude
budget-note = incertitude-type
budget-together = Composée
revisions-computed-again = recalculée ; pointée par
revisions-title = Historique
revisions-who = { $person }, { $time }
revisions-review = { $person } – { $reason }
catalogue-list = { $field } dans le catalogue
catalogue-other-years = Le catalogue n’a { $model } que pour { $years }. Vérifiez l’année.
passes-find = Détecter les passages
passes-find-title = Détecter les passages de véhicules dans cette vidéo. Les passages existants ou écartés ne changent pas.
passes-failed = La détection a échoué ; relancez-la.
passes-cancelled = La détection des passages dans { $recording } a été annulée.
passes-found = { $recording } : { $message }
passes-over = { $recording } : détection terminée.
passes-show-all = Tous
passes-show-to_do = À faire
passes-show-rejected = Rejetés
passes-show-measured = Mesurés
passes-show-doubtful = Douteux
passes-show-no_class = Sans classe
passes-doubts = { $count ->
    [one] Une hauteur est inhabituelle : vérifiez-la.
   *[other] { NUMBER($count) } hauteurs sont inhabituelles : vérifiez-les.
}
passes-class-missing = La classe manque.
passes-show-left_out = hors échantillon
passes-by-number = par numéro
passes-by-time = par heure
passes-by-state = par état

## L’image : vue, loupe, frise, lecture

viewer-frame = image { $frame }
viewer-frame-label = Image { $frame }
viewer-frame-at = image { $frame }, { $time }
viewer-stand-in = vignette de l’image { $thumbnail } ; chargement de l’image { $frame }
viewer-what = image
viewer-layers = Axes et points sur l’image
viewer-bright = éclaircie (affichage seulement)
viewer-pointer = x { $x } y { $y }
viewer-wrong-frame = Le serveur a envoyé l’image { $served } pour l’image { $frame } : elle n’est pas affichée ; importez à nouveau l’enregistrement.
viewer-slid = Rien n’a été placé : le pointeur a bougé alors que le bouton était enfoncé. Pour déplacer l’image, maintenez Espace et faites glisser.
viewer-changed = Rien n’a été placé : l’image a changé alors que le bouton était enfoncé. Cliquez à nouveau.
viewer-first-corner = premier
timeline-passes = { NUMBER($count) } passages, images { $first_frame } à { $last_frame }
timeline-label = Position dans l’enregistrement
timeline-decoded = Décodé sur le serveur
transport-play = Lire
transport-stop = Pause
transport-frame = image
transport-of = sur { $last_frame }
transport-vfr-title = Cadence d’images variable : les temps viennent de l’horodatage de chaque image
blind-elsewhere = Ce n’est pas l’image à pointer ; allez à l’image { $frame }.
blind-contact = cliquez là où le pneu touche la chaussée
blind-target = { $target ->
    [roof] cliquez sur { target-hint-roof }
    [driver_eye] cliquez sur { target-hint-driver_eye }
    [taillight] cliquez sur { target-hint-taillight }
    [headlight] cliquez sur { target-hint-headlight }
   *[other] cliquez sur { target-hint-other }
}
blind-wrong-frame = Pointez sur l’image { $frame }, celle des premiers pointés.

## Caméra : la page

camera-lead = Un boîtier et un objectif, à un réglage de zoom et de mise au point. L’étalonnage donne les paramètres de l’objectif et leur incertitude.
camera-another = Autre caméra
camera-loading-all = caméras
camera-loading = caméra
camera-none-title = Pas encore de caméra
camera-none = Nommez la caméra qui a filmé ce site. Déposez ensuite une quinzaine de photos d’un damier, prises avec elle au même zoom et à la même mise au point, ou un fichier d’étalonnage issu d’un autre outil.
camera-add-first = Ajouter la caméra
camera-list = Caméras
camera-take-open = Depuis un autre relevé
camera-take-title = Copier une caméra d’un autre relevé
camera-take = Copier
camera-take-lead = Copie l’étalonnage en vigueur et ses photos. Les deux relevés sont ensuite indépendants : un nouvel étalonnage dans l’un ne change aucune hauteur dans l’autre.
camera-take-survey = Relevé
camera-take-camera = Caméra
camera-take-none = Aucune caméra de ce relevé n’est étalonnée.
camera-take-no-other = Il n’y a pas encore d’autre relevé.
camera-taken-from = copiée de { $place }
camera-add = Ajouter une caméra
camera-name = Caméra { $number }
camera-edit = Modifier
camera-edit-title = { $camera }
camera-words-none = Objectif, zoom et mise au point non indiqués.
camera-zoomed = zoom { $zoom }
camera-focused = mise au point { $focus }
camera-lens-words = Objectif
camera-lens-words-hint = Marque et plage, telles que gravées : 24-70 mm f/2.8.
camera-zoom = Zoom
camera-zoom-hint = Tel que réglé, et s’il est bloqué par un adhésif : 28 mm, bloqué.
camera-focus = Mise au point
camera-focus-hint = Manuelle, et la distance. L’autofocus modifie l’objectif à chaque photo.
camera-name-problem = Donnez un nom à la caméra.
camera-notes-hint = Boîtier, taille d’image, stabilisation désactivée. Si l’un d’eux change, étalonnez à nouveau.

## Caméra : l’étalonnage

camera-calibrate = Étalonner
camera-calibrate-again = Étalonner à nouveau
camera-where-boards = Source des photos de la mire
camera-from-images = Dans des photos
camera-from-clip = Dans un enregistrement
camera-choose-pictures = Choisir des photos du damier
camera-drop-pictures = Déposez ici des photos du damier, ou cliquez pour choisir
camera-drop-hint = Même caméra, même zoom, même mise au point. Inclinez la mire, amenez-la dans chaque coin, gardez-la nette.
camera-found-in = { $count ->
    [one] La mire a été trouvée dans <strong>{ $found }</strong> image sur { NUMBER($count) }.
   *[other] La mire a été trouvée dans <strong>{ $found }</strong> des { NUMBER($count) } images.
}
camera-too-few = Il en faut au moins trois ; douze à vingt, prises sous divers angles, donnent un bon étalonnage.
camera-more-better = Suffisant pour étalonner. Douze à vingt photos, la mire inclinée et dans chaque coin de l’image, donnent un meilleur résultat.
camera-other-board = Ces photos ont été analysées pour une autre mire. Relancez la recherche pour { $columns } × { $rows } coins intérieurs.
camera-other-board-markers = Ces photos ont été analysées pour une autre mire. Relancez la recherche pour { $columns } × { $rows } coins intérieurs et des marqueurs de { $dictionary }.
camera-look-again = Relancer la recherche
camera-to-go = { $count ->
    [one] encore { NUMBER($count) } image
   *[other] encore { NUMBER($count) } images
}
camera-import = Importer un fichier d’étalonnage
camera-import-title = OpenCV YAML ou JSON, ROS camera_info, Kalibr, mrcal
camera-imported = { $file } importé.
camera-failed = L’étalonnage a échoué ; réessayez.
camera-recording-frames = { $count ->
    [one] { $recording } ({ NUMBER($count) } image)
   *[other] { $recording } ({ NUMBER($count) } images)
}
camera-every = Une image sur n
camera-first-frame = Première image
camera-last-frame = Dernière image
camera-no-recording = Aucun enregistrement n’est prêt ; <link>ajoutez la vidéo</link> où la mire est déplacée.
camera-every-problem = Saisissez un nombre entier, 1 ou plus.
camera-frames-problem = Saisissez la première et la dernière image en nombres entiers.
camera-frames-order = La dernière image est avant la première.
camera-frames-end = L’enregistrement finit à l’image { $last_frame }.
camera-lens = Objectif
camera-lens-brown = Sténopé
camera-lens-fisheye = Fisheye
camera-lens-brown-hint = Sténopé avec distorsion de Brown-Conrady : jusqu’à environ 100° de champ.
camera-lens-fisheye-hint = Équidistant à quatre termes : pour les objectifs de plus de 100° de champ environ.
camera-board = Mire
camera-board-flat = Mire plane
camera-board-bent = Peut-être courbée
camera-board-flat-hint = Sur une plaque rigide. Le résultat indique sa planéité.
camera-board-bent-hint = Papier sur un mur ou feuille mince : la forme de la mire est aussi estimée. Il faut 6 vues, mieux 15.
camera-three-images = Ajoutez au moins trois photos où l’on voit la mire.
camera-corners-found = { $count ->
    [one] { NUMBER($count) } coin trouvé dans { $image }
   *[other] { NUMBER($count) } coins trouvés dans { $image }
}
camera-remove = Retirer { $image }
camera-found-some = trouvés : { $found } sur { $all }
camera-found-all = { $columns } × { $rows } trouvés

## Caméra : la mire

camera-inner-corners = Comptez les <strong>coins intérieurs</strong> : les points où quatre cases se touchent. Une mire de 10 sur 7 cases en a 9 sur 6.
camera-charuco-corners = Les fabricants de mires ChArUco indiquent souvent les cases : retranchez un dans chaque sens. Une partie de la mire dans l’image suffit.
camera-columns = Colonnes
camera-rows = Rangées
camera-square = Côté d’une case
camera-square-hint = Mesurez dix cases à la règle et divisez par dix : les imprimantes respectent rarement les dimensions.
camera-square-problem = { $unit ->
    [ft] Saisissez le côté d’une case en pouces, par exemple { $example }.
   *[m] Saisissez le côté d’une case en millimètres, par exemple { $example }.
}
camera-count-problem = { $what ->
    [rows] Saisissez le nombre de rangées, un nombre entier.
   *[columns] Saisissez le nombre de colonnes, un nombre entier.
}
camera-count-range = { $what ->
    [rows] De 3 à 50 rangées peuvent être détectées ; recomptez les coins intérieurs.
   *[columns] De 3 à 50 colonnes peuvent être détectées ; recomptez les coins intérieurs.
}
camera-print = Imprimer cette mire (PDF)
camera-print-hint = En vraie grandeur, sur la plus petite feuille qui la contient, avec une échelle pour contrôler l’impression. Collez-la sur un support plan.
camera-drawing = { $kind ->
    [charuco] Une mire ChArUco, aux marqueurs dans les cases blanches, avec { $columns } coins intérieurs en largeur et { $rows } en hauteur : les points où quatre cases se touchent. Le bord extérieur ne compte pas.
   *[checkerboard] Une mire avec { $columns } coins intérieurs en largeur et { $rows } en hauteur : les points où quatre cases se touchent. Le bord extérieur ne compte pas.
}
camera-drawing-columns = { $count ->
    [one] { NUMBER($count) } colonne
   *[other] { NUMBER($count) } colonnes
}
camera-drawing-rows = { $count ->
    [one] { NUMBER($count) } rangée
   *[other] { NUMBER($count) } rangées
}
camera-drawing-square = case { $side }

## Caméra : un étalonnage

camera-calibrations = Étalonnages
camera-loading-calibration = étalonnage
camera-trusted = Étalonnage fiable
camera-not-trusted = Étalonnage non fiable
camera-made = { $source ->
    [import] Importé { $time }
    [clip] D’un enregistrement, { $time }
   *[images] De photos, { $time }
}
camera-made-by = { $source ->
    [import] Importé { $time }, { $person }
    [clip] D’un enregistrement, { $time }, { $person }
   *[images] De photos, { $time }, { $person }
}
camera-use = Utiliser cet étalonnage
camera-residual = Erreur de reprojection RMS
camera-not-told = Non indiquée
camera-download = camera.json
camera-views-used = { $count ->
    [one] { $used } vue utilisée sur { NUMBER($count) }
   *[other] vues utilisées : { $used } sur { NUMBER($count) }
}
camera-picture = taille d’image
camera-across = { $model ->
    [fisheye] fisheye, champ horizontal d’environ { $angle }°
   *[brown] sténopé, champ horizontal d’environ { $angle }°
}
camera-u = u = { $u }
camera-u-note = u est l’incertitude-type (k = 1).
camera-fx = focale fx
camera-fy = focale fy
camera-cx = point principal cx
camera-cy = point principal cy
camera-distortion = distorsion { $name }
camera-coverage-unknown = La couverture de l’image n’est pas connue pour cet étalonnage.
camera-coverage = Les coins couvrent { $percent } % de l’image.
camera-coverage-label = Couverture de l’image : { $empty } parties sur { $all } sans aucun coin
camera-coverage-cell = { $count ->
    [one] { NUMBER($count) } coin
   *[other] { NUMBER($count) } coins
}
camera-covered = Toutes les parties de l’image sont assez couvertes.
camera-reshoot = Vues à ajouter
camera-residuals = Résidus par vue
camera-left-out = { $count ->
    [one] { NUMBER($count) } vue exclue
   *[other] { NUMBER($count) } vues exclues
}
camera-no-reason = motif non indiqué
camera-residuals-label = Résidus de { $file }, le plus long de { $longest_px } pixels
camera-worst-view = Pire vue.
camera-residuals-drawn = { $file } : résidus dessinés { $times } fois plus longs ; le plus long est de { $longest_px } px.
camera-history-made = Établi
camera-history-by = Par
camera-history-from = Origine
camera-history-verdict = Conclusion
camera-history-summary = Résumé
camera-history-show = Afficher
camera-history-shown = affiché
camera-show = Afficher
camera-source-images = photos
camera-source-clip = un enregistrement
camera-source-import = un fichier

## Caméra : les contrôles d’un étalonnage

camera-checks = Contrôles
camera-halves = Validation croisée (deux moitiés)
camera-halves-not-done = Non faite. { $reason }
camera-halves-nothing = Le champ de vision est trop étroit pour comparer des hauteurs.
camera-halves-differ = Les deux moitiés diffèrent de { $differences } sur une hauteur.
camera-difference-at = { $difference } à { $distance }
camera-held-out = Erreur de reprojection RMS, images hors ajustement : { $held_out } ; images ajustées : { $fit }.
camera-under = moins de { $length }
camera-vehicle-at = Véhicule à
camera-heights-differ = Écart de hauteur
camera-expected = u attendue (k = 1)
camera-not-in-picture = hors de l’image
camera-halves-note = Hauteur d’un œil à { $eye } calculée avec chaque moitié (caméra horizontale à { $camera }, mire à { $board }, mêmes pointés). « Attendue » : l’écart dû au seul bruit des coins.
camera-flatness = Défaut de planéité de la mire
camera-board-solved = Forme estimée : flèche de la mire { $bow }. Erreur de reprojection RMS { $flat } si elle est supposée plane, { $bent } avec sa forme estimée.
camera-board-taken-flat = Supposée plane. D’après les photos, flèche de la mire { $bow }. Erreur de reprojection RMS { $flat } si elle est supposée plane, { $bent } avec sa forme estimée.

## Pose de la caméra : la page

pose-loading = pose de la caméra
pose-no-recording-title = Pas encore d’enregistrement avec la mire
pose-no-recording = Ajoutez la vidéo où le damier est posé sur la chaussée ; la pose de la caméra en est calculée.
pose-add-recordings = Ajouter des enregistrements
pose-mark-first = Marquer la première image de la mire
pose-mark-last = Marquer la dernière image de la mire
pose-side = Mire et résultat
pose-board-span = Mire : images { $first_frame } à { $last_frame }
pose-go-again = Cet enregistrement a une pose de la caméra. Pour la recalculer, allez à une image où la mire est immobile.
pose-go = Allez à une image où la mire est immobile.
pose-looking = Recherche de la mire…
pose-found-part = Trouvée en partie
pose-found = { $columns } × { $rows } trouvés
pose-chosen = Cette pose est maintenant en vigueur pour l’enregistrement ; les nouvelles mesures l’utilisent.

## Pose de la caméra : les questions

pose-lens = Enregistrement et objectif
pose-calibration-none = aucun
pose-calibration = { $state ->
    [current] { $camera }, { $calibration }, en vigueur
    [current_not_trusted] { $camera }, { $calibration }, en vigueur, non fiable
    [not_trusted] { $camera }, { $calibration }, non fiable
   *[other] { $camera }, { $calibration }
}
pose-board = La mire
pose-columns = Coins intérieurs en largeur
pose-rows = et en hauteur
pose-square = Case
pose-corners-hint = Les coins intérieurs sont là où quatre cases se touchent : une mire de 10 sur 7 cases en a 9 sur 6.
pose-charuco-hint = Une pose de la caméra exige que la mire soit visible en entier.
pose-still = Images à mire immobile
pose-begins = Début ici
pose-begins-title = La première image
pose-ends = Fin ici
pose-ends-title = La dernière image
pose-span-offer = La mire est immobile de l’image { $first_frame } à { $last_frame }.
pose-span-take = Utiliser ces images
pose-not-marked = non marquées
pose-end-not-marked = à partir de { $first_frame }, fin non marquée
pose-marked = { $count ->
    [one] { $first_frame } à { $last_frame }, { NUMBER($count) } image
   *[other] { $first_frame } à { $last_frame }, { NUMBER($count) } images
}
pose-height = Hauteur de la mire
pose-reference = Rangée de référence
pose-reference-bottom = rangée de coins la plus basse
pose-reference-top = rangée la plus haute
pose-reference-height = { $reference ->
    [top] De la chaussée à la rangée de coins intérieurs la plus haute
   *[bottom] De la chaussée à la rangée de coins intérieurs la plus basse
}
pose-reference-height-hint = À mesurer pour chaque enregistrement : elle n’est jamais reprise d’un autre.
pose-drawing = { $reference ->
    [top] Le mètre ruban va de la chaussée à la rangée de coins intérieurs la plus haute.
   *[bottom] Le mètre ruban va de la chaussée à la rangée de coins intérieurs la plus basse.
}
pose-drawing-tape = ruban
pose-drawing-road = chaussée
pose-sure = Incertitudes-types
pose-u-tape = u(hauteur)
pose-u-lean = u(inclinaison et roulis)
pose-u-square = u(côté de case)
pose-u-bow = u(planéité)
pose-u-hint = Les valeurs par défaut sont des évaluations de type B : mètre ruban en acier sur enrobé 3 mm ; niveau à bulle 0,3° (inclinaison comme roulis) ; case imprimée 0,1 % ; planéité d’une mire rigide 0,5 mm. Chacune est une ligne du bilan d’incertitude.
pose-find = Calculer la pose de la caméra
pose-find-again = Recalculer la pose de la caméra
pose-stopped = Arrêté ; rien n’a changé.
pose-look-only = Lecture seule. Un opérateur calcule la pose.
pose-problem-calibration = Étalonnez d’abord la caméra. La pose exige les paramètres de l’objectif.
pose-problem-board = Il faut une mire d’au moins 2 sur 2 coins intérieurs.
pose-problem-square = Indiquez le côté d’une case : mesurez plusieurs cases d’un coup et divisez.
pose-problem-height = Indiquez la hauteur mesurée au mètre ruban.
pose-problem-u = Chacune doit être un nombre positif ou nul.
pose-problem-span = Marquez les images où la mire est immobile.

## Pose de la caméra : le résultat

pose-result = Pose de la caméra de l’enregistrement
pose-download = pose.json
pose-result-earlier = Pose antérieure de la caméra
pose-use = Utiliser cette pose pour l’enregistrement
pose-measure = Commencer à mesurer
pose-expected = Incertitude attendue d’une hauteur
pose-expected-distance = Distance
pose-expected-good = U95 de la hauteur
pose-expected-U95 = ± { $U95 }
pose-expected-reason = Pas d’U95 à { $distance }. { $reason }
pose-facts = Images { $first_frame } à { $last_frame } ; résidu des coins { $fit } ; mire à { $distance }.
pose-other-recording = autre enregistrement
pose-poses = { $count ->
    [one] { NUMBER($count) } pose dans ce relevé
   *[other] { NUMBER($count) } poses dans ce relevé
}
pose-made = { $time }, images { $first_frame } à { $last_frame }
pose-use-short = Utiliser

## Enregistrements

recordings-lead = Les numéros d’images sont les mêmes pour tous. Les bandes de balayage linéaire s’ajoutent sous Balayages.
recordings-loading = enregistrements
recordings-choose = Choisir des vidéos à envoyer
recordings-drop = Déposez des vidéos ici, ou cliquez pour choisir
recordings-drop-hint = Un envoi interrompu reprend là où il s’est arrêté, même après la fermeture de cette page.
recordings-uploads = Envois
recordings-none-title = Pas encore d’enregistrements
recordings-none = Ajoutez la vidéo du jour : MP4, MOV, AVI, MKV et autres. Ajoutez aussi celle du damier sur la chaussée : la pose de la caméra en est calculée.
recordings-none-look = Un opérateur peut envoyer ici la vidéo du jour.
recordings-delete-title = Supprimer { $recording } ?
recordings-delete-body = La vidéo, sa table d’images et ses passages seront supprimés. Un enregistrement avec des mesures ne peut pas être supprimé.
recordings-delete = Supprimer l’enregistrement
recordings-delete-one = Supprimer { $recording }
recordings-download-one = Télécharger la vidéo de { $recording }
recordings-deleted = { $recording } a été supprimé.
recordings-vfr-title = Cadence d’images variable : les temps viennent de l’horodatage de chaque image
recordings-picture-read = Piste vidéo { $number } sur les { NUMBER($count) } du fichier
recordings-picture-read-too = Importer aussi la piste vidéo { $number } ({ $codec }, { $size })
recordings-picture-read-of = Importer la piste vidéo { $number } de { $recording } comme un enregistrement à part
recordings-picture-added = { $name } est en cours d’import.
recordings-filming-rate-unknown = Cadence de prise de vue non confirmée ; aucun mouvement n’est mesuré.
recordings-filming-rate-is = Filmé à { $rate } images/s, valeur saisie
recordings-filming-rate-state = Saisir la cadence de prise de vue
recordings-filming-rate-of = Saisir la cadence de prise de vue de { $recording }
recordings-filming-rate-title = Cadence de prise de vue de { $recording }
recordings-filming-rate = Cadence de prise de vue
recordings-filming-rate-unit = images/s
recordings-filming-rate-hint = D’après les réglages de la caméra ou sa notice. La vidéo est importée à nouveau avec ces instants ; les hauteurs déjà mesurées restent.
recordings-filming-rate-bounds = Saisissez un nombre de 1 à 2000.
recordings-filming-rate-action = Importer à cette cadence
recordings-find-road = Calculer la pose
recordings-measure = Mesurer
recordings-read-again = Importer à nouveau
recordings-unreadable = Cet enregistrement n’a pas pu être importé.
recordings-no-picture = pas d’image
recordings-no-picture-yet = pas encore d’image
recordings-rename = Renommer
recordings-rename-one = Renommer { $recording }
recordings-name = Nom de l’enregistrement
recordings-frames = { $count ->
    [one] { NUMBER($count) } image
   *[other] { NUMBER($count) } images
}
recordings-rate = { $rate } images/s
recordings-rate-average = { $rate } images/s en moyenne
recordings-codec = { $codec } dans { $container }
recordings-passes = { $count ->
    [0] encore aucun passage
    [one] { NUMBER($count) } passage
   *[other] { NUMBER($count) } passages
}
recordings-sha256 = SHA-256 { $sha256 }
recordings-no-camera = Pas encore de caméra : <link>étalonnez-en une</link>.
recordings-camera = Caméra
recordings-camera-unsaid = Non indiquée
recordings-camera-uncalibrated = { $camera } (non étalonnée)
recordings-lighting = Luminosité
recordings-lighting-proposed = Luminosité <muted>(proposée)</muted>
recordings-lighting-of = Luminosité de { $recording }
recordings-lighting-of-proposed = Luminosité de { $recording }, proposée par Sightline
recordings-lighting-guess = { $lighting } (proposée)

filmed-start = Début du film : { $time } ({ $zone })
filmed-at = filmé { $time }
filmed-proposed = Début non confirmé ; proposé d’après le fichier : { $time } ({ $zone })
filmed-unknown = Début inconnu : le fichier n’en indique pas.
filmed-edit = Modifier
filmed-edit-of = Modifier le début et la météo de { $recording }
filmed-confirm = Confirmer le début
filmed-enter = Saisir le début
filmed-confirm-of = Confirmer le début de { $recording }
filmed-enter-of = Saisir le début de { $recording }
filmed-confirm-action = Confirmer
filmed-title = Début et météo de { $recording }
filmed-started = Première image, heure locale
filmed-unsay = Inconnu
filmed-from-file = Proposé d’après le fichier : { $time }. L’horloge d’une caméra est souvent fausse de quelques minutes, ou d’une heure (heure d’été) : comparez avec une montre filmée ou avec vos notes.
filmed-from-file-none = Le fichier n’indique pas d’heure : prenez-la d’une montre filmée ou de vos notes.
filmed-zone = Fuseau horaire
filmed-which = Cette heure a eu lieu deux fois
filmed-first = la première fois ({ $offset })
filmed-second = la seconde fois ({ $offset })
filmed-weather = Météo
filmed-weathers = dégagé, quelques nuages, couvert, brouillard, pluie faible, pluie, neige
filmed-lamps = Éclairage public
filmed-lamps-on = allumé
filmed-lamps-off = éteint
filmed-lamps-are = { $state ->
    [on] éclairage public allumé
   *[off] éclairage public éteint
}
filmed-not-said = Non indiqué

## Envois

upload-state = { $state ->
    [waiting] { $file } : démarrage
    [paused] { $file } : en pause
    [retrying] { $file } : connexion perdue, nouvel essai
    [failed] { $file } : arrêté
    [read] { $file } : envoyé, import en cours
    [kept] { $file } : envoyé
   *[sending] { $file } : envoi en cours
}
upload-resumed = { $file } : envoi, repris à { $arrived }
upload-amount = { $arrived } sur { $size }
upload-rate = { $arrived } sur { $size } · { $speed }/s · reste { $time }
upload-pause = Pause
upload-resume = Reprendre
upload-cancel = Annuler l’envoi de { $file }
upload-empty = { $file } est vide ; vérifiez la copie, puis choisissez à nouveau le fichier.
upload-not-loaded = La page n’a pas été chargée en entier ; rechargez-la et choisissez à nouveau le fichier.
upload-broken = La connexion a été coupée pendant l’envoi de { $file } ; ce qui est arrivé est gardé : appuyez sur « Reprendre » quand la connexion sera rétablie.
upload-unfinished = { $file } : inachevé ; déposez à nouveau le même fichier pour reprendre l’envoi
upload-discard-title = Supprimer l’envoi partiel ?
upload-discard-body = { $arrived } de { $file } sont sur le serveur.
upload-discard = Supprimer
upload-discard-one = Supprimer l’envoi partiel de { $file }

## Mots utiles à beaucoup de pages

interval = { $low } à { $high }
words-apart = { $first } ; { $second }
person-system = Sightline
person-unknown = inconnu
menu-language = Langue
stage-frame = Image
stage-frames = Images
stage-timeline = Frise
stage-fit = Ajuster
stage-lines = Lignes
stage-bright = Clair
stage-loupe = Loupe
vfr = VFR
field-name = Nom
field-recording = Enregistrement
field-calibration = Étalonnage
in-use = en vigueur
field-notes = Notes
action-add = Ajouter
action-cancel = Annuler
action-close = Fermer
dialog-discard-title = Abandonner votre saisie ?
dialog-discard-body = Elle n’est pas enregistrée.
dialog-discard = Abandonner
action-dismiss = Fermer
action-save = Enregistrer
action-try-again = Réessayer
action-clear-filter = Effacer les filtres
action-print = Imprimer
file-csv = CSV
figure-share-of-vehicles = Part des véhicules (%)
with-unit = { $name } ({ $unit })
percent = { $percent } %
with-u = { $value } (u = { $u })
value-px = { $value } px
value-s = { $value } s
file-svg = SVG
unit-px = px
unit-byte = o
unit-hz = Hz
unit-ppm = ppm
unit-mrad = mrad

## Contrôles : la page

adjust-lead = Comparez la pose de la caméra à des véhicules d’empattement et de hauteur connus. Rien ne change tant que vous n’appliquez pas la pose ajustée ; les hauteurs sont alors recalculées, et le tout peut être annulé en une fois.
adjust-tab = Ajustement
adjust-loading = ajustement
adjust-no-pose = Aucun enregistrement n’a encore de pose de la caméra.
adjust-pose = Pose de la caméra { $pose } : { $recordings }
adjust-seen = Véhicules avec les deux pneus et un empattement connu : { $tyres } ; avec un toit mesuré et une hauteur connue : { $roofs }.
adjust-u-wheelbase = u par défaut d’un empattement ({ $unit })
adjust-u-wheelbase-common = u commune à tous les empattements ({ $unit })
adjust-u-roof-common = u commune à tous les toits ({ $unit })
adjust-u-problem = Saisissez une longueur de 0 à 1 m, par exemple { $example }.
adjust-used = Observations utilisées : { $used } sur { $passes }.
adjust-global-holds = Le test global est satisfait : khi-deux { $chi2 } à { $freedom ->
    [one] { NUMBER($freedom) } degré
   *[other] { NUMBER($freedom) } degrés
 } de liberté, sous la limite { $limit }.
adjust-global-fails = Le test global échoue : khi-deux { $chi2 } à { $freedom ->
    [one] { NUMBER($freedom) } degré
   *[other] { NUMBER($freedom) } degrés
 } de liberté, au-dessus de la limite { $limit } ; les incertitudes indiquées ne sont pas compatibles entre elles.
adjust-largest = Plus grande variation d’une hauteur enregistrée : { $largest }.
adjust-adjusted = Cette pose a été ajustée sur le trafic. La pose précédente est le numéro { $pose }.
adjust-put = Appliquer
adjust-put-done = La pose ajustée est en vigueur.
adjust-take-back = Annuler
adjust-taken-back = La pose précédente est à nouveau en vigueur.
adjust-moved-title = Variation des paramètres
adjust-what = Paramètre
adjust-value = Variation
adjust-by-u = Variation / u
adjust-by-u-help = La variation divisée par l’incertitude-type d’avant
adjust-u-before = u avant
adjust-u-after = u après
adjust-moved-camera_height_m = hauteur de la caméra au-dessus de la chaussée
adjust-moved-road_lean_rad = rotation de la chaussée autour de son axe longitudinal (inclinaison)
adjust-moved-road_roll_rad = rotation de la chaussée autour de l’axe transversal (roulis)
adjust-moved-board_lean_rad = inclinaison de la mire
adjust-moved-board_roll_rad = roulis de la mire
adjust-moved-board_height_m = hauteur de la rangée de référence de la mire
adjust-moved-square_m = côté d’une case de la mire
adjust-moved-bow_along_rows_m = flèche de la mire le long des rangées
adjust-moved-bow_down_columns_m = flèche de la mire le long des colonnes
adjust-moved-wheelbase_common_m = erreur commune à tous les empattements
adjust-moved-roof_common_m = erreur commune à tous les toits
adjust-moved-roof_inset_common_m = erreur commune à tous les toits de même retrait supposé
adjust-common-of = { $what } ({ $length })
adjust-left-title = Non utilisées
adjust-left-none = Toutes les observations sont utilisées.
adjust-of-tyres = pneus
adjust-of-roof = toit
adjust-models-title = Un modèle exclu à la fois
adjust-models-note = Variation de la hauteur de la caméra quand tous les véhicules d’un modèle sont exclus. Un modèle qui domine le résultat se voit ici.
adjust-model = Modèle
adjust-vehicles = Véhicules
adjust-camera = Hauteur de la caméra
adjust-heights-title = Effet sur chaque hauteur
adjust-now = Actuelle
adjust-then = Ajustée
computing-lead = Les hauteurs dépendent de la pose de la caméra (dans les balayages : de l’étalonnage au jalon), du retrait, du côté du conducteur et de la version de Sightline. Quand l’un d’eux change, les hauteurs enregistrées restent inchangées jusqu’à leur recalcul ici : en nouvelles révisions, comparées aux anciennes, annulables en une fois.
computing-loading = hauteurs périmées
computing-fine = Toutes les hauteurs sont à jour.
computing-stale = { $count ->
    [one] { NUMBER($count) } hauteur est périmée : { $causes }.
   *[other] { NUMBER($count) } hauteurs sont périmées : { $causes }.
}
computing-in-line-scans = { $count ->
    [one] { NUMBER($count) } est dans un balayage.
   *[other] { NUMBER($count) } sont dans des balayages.
}
computing-waiting = { $count ->
    [one] { NUMBER($count) } de ces mesures n’a pas encore de hauteur et en aura une.
   *[other] { NUMBER($count) } de ces mesures n’ont pas encore de hauteur et en auront une.
}
computing-other-program = { $count ->
    [one] { NUMBER($count) } hauteur a été calculée par une autre version de Sightline. Le recalcul peut donner la même valeur.
   *[other] { NUMBER($count) } hauteurs ont été calculées par une autre version de Sightline. Le recalcul peut donner les mêmes valeurs.
}
computing-cause-pose = { NUMBER($count) } avec une autre pose ou un autre étalonnage de la caméra
computing-cause-inset = { NUMBER($count) } avec un autre retrait
computing-cause-side = { NUMBER($count) } avec un autre côté du conducteur
computing-cause-program = { NUMBER($count) } par une autre version de Sightline
computing-start = Recalculer
computing-look = Vérifier et recalculer
computing-which = Quelles hauteurs
computing-mark-pose = Périmée : la pose de la caméra a changé depuis.
computing-mark-inset = Périmée : le retrait a changé depuis.
computing-mark-side = Périmée : le côté du conducteur a changé depuis.
computing-mark-program = Périmée : une autre version de Sightline l’a calculée.
computing-nothing-changed = Aucune hauteur n’a changé : rien n’a été enregistré.
computing-done = { $count ->
    [one] { NUMBER($count) } hauteur recalculée.
   *[other] { NUMBER($count) } hauteurs recalculées.
}
computing-runs = Calculs précédents
computing-runs-none = Aucune hauteur n’a été recalculée dans ce relevé.
computing-when = Quand
computing-who = Par
computing-kind = Motif
computing-kind-asked = demandé
computing-kind-sides = côté du conducteur indiqué
computing-kind-adjustment = pose ajustée mise en vigueur
computing-kind-undo = annulation
computing-heights = Hauteurs
computing-to-review = À vérifier
computing-largest = Plus grande variation
computing-undone = annulé
computing-show = Afficher
computing-shown = affiché
computing-old-new = Ancienne et nouvelle
computing-summary = { $count ->
    [one] { NUMBER($count) } hauteur : { $causes } ; variation moyenne { $mean }, la plus grande { $largest }.
   *[other] { NUMBER($count) } hauteurs : { $causes } ; variation moyenne { $mean }, la plus grande { $largest }.
}
computing-summary-undo = { $count ->
    [one] { NUMBER($count) } hauteur a retrouvé sa valeur précédente.
   *[other] { NUMBER($count) } hauteurs ont retrouvé leur valeur précédente.
}
computing-kept = { $count ->
    [one] { NUMBER($count) } a été modifiée depuis et reste inchangée.
   *[other] { NUMBER($count) } ont été modifiées depuis et restent inchangées.
}
computing-sent = { $count ->
    [0] Aucune hauteur n’a changé de plus que son incertitude-type : toutes les décisions restent valables.
    [one] { NUMBER($count) } hauteur a changé de plus que son incertitude-type et retourne en vérification ; les autres décisions restent valables.
   *[other] { NUMBER($count) } hauteurs ont changé de plus que leur incertitude-type et retournent en vérification ; les autres décisions restent valables.
}
computing-undo = Tout annuler
computing-undo-text = Rétablit la valeur précédente de chaque hauteur de ce calcul, en nouvelle révision. Les hauteurs modifiées depuis restent inchangées.
computing-figure = Variation de chaque hauteur
computing-figure-says = Variation de { NUMBER($count) } hauteurs selon la position latérale de leur contact, en { $small }.
computing-figure-lines = Variation de chaque hauteur dans les balayages
computing-figure-says-lines = Variation de { NUMBER($count) } hauteurs dans les balayages selon la distance du contact à la caméra, en { $small }.
computing-figure-x-lines = distance du contact à la caméra ({ $unit })
computing-line-scan = balayage
computing-figure-x = position latérale du contact ({ $unit })
computing-figure-y = nouvelle − ancienne ({ $small })
computing-figure-note = Plein : variation supérieure à l’incertitude-type d’avant. Une variation qui croît avec la distance vient de la pose de la caméra ; une variation égale pour toute une cible, de son retrait.
computing-figure-none = Aucune hauteur n’existe à la fois avant et après.
computing-vehicle = Véhicule
computing-target = Cible
computing-before = Ancienne
computing-after = Nouvelle
computing-change = Variation
computing-by-u = Variation / u
computing-by-u-help = Variation divisée par l’incertitude-type précédente
computing-review-yes = à vérifier
computing-repeat = répétition
computing-listed = Les { NUMBER($count) } plus grandes variations rapportées à u sont affichées ; l’archive les contient toutes.
computing-table = Anciennes et nouvelles hauteurs
computing-job = tâche
checks-again = Recalcul
checks-lead = Comparez les retraits et les axes de la route aux véhicules mesurés.
checks-loading = contrôles
checks-insets = Retraits
checks-direction = Direction
checks-eye = Œil du conducteur

## Contrôles : les retraits

checks-insets-title = Retraits : en vigueur, et estimés d’après ce relevé
checks-insets-loading = estimations
checks-insets-table = Retraits en vigueur
checks-target = Cible
checks-in-force = En vigueur
checks-from = Source
checks-inset-and-u = Retrait, u de la moyenne
checks-moves = Effet sur la hauteur
checks-insets-note = Un nouveau retrait ne vaut que pour les nouvelles mesures ; les mesures existantes gardent le leur jusqu’au recalcul. Son u vaut pour un seul véhicule : elle réunit celle de la moyenne et la dispersion entre véhicules.
checks-by-known_heights = hauteurs du constructeur
checks-by-trend = tendance avec la distance
checks-by-two_frames = mesures sur deux images
checks-measurements = { $count ->
    [one] { NUMBER($count) } mesure
   *[other] { NUMBER($count) } mesures
}
checks-other-insets = { NUMBER($count) } avec un autre retrait, hors calcul
checks-estimate = estimation
checks-vehicles = { $count ->
    [one] { NUMBER($count) } véhicule
   *[other] { NUMBER($count) } véhicules
}
checks-vehicles-without = { $count ->
    [one] { NUMBER($count) } véhicule
   *[other] { NUMBER($count) } véhicules
} <without>sans { $left_out }</without>
checks-left-out-help = Valeurs aberrantes : contrôlez leurs pointés et leurs hauteurs.
checks-spread = { $spread } entre véhicules
checks-use = { $target ->
    [roof] Utiliser { $inset } (u = { $u_inset }) pour les toits de voitures
    [roof_van] Utiliser { $inset } (u = { $u_inset }) pour les toits de fourgons
    [roof_box] Utiliser { $inset } (u = { $u_inset }) pour les toits de camions et de bus
    [roof_unknown] Utiliser { $inset } (u = { $u_inset }) pour les toits sans classe
    [driver_eye_near] Utiliser { $inset } (u = { $u_inset }) pour les yeux de conducteur côté proche
    [driver_eye_far] Utiliser { $inset } (u = { $u_inset }) pour les yeux de conducteur côté éloigné
    [taillight] Utiliser { $inset } (u = { $u_inset }) pour les feux arrière
    [headlight] Utiliser { $inset } (u = { $u_inset }) pour les projecteurs
   *[other] Utiliser { $inset } (u = { $u_inset }) pour les autres cibles
}
checks-used = { $target ->
    [roof] Les nouvelles mesures de toits de voitures utilisent le nouveau retrait ; les mesures existantes gardent le leur.
    [roof_van] Les nouvelles mesures de toits de fourgons utilisent le nouveau retrait ; les mesures existantes gardent le leur.
    [roof_box] Les nouvelles mesures de toits de camions et de bus utilisent le nouveau retrait ; les mesures existantes gardent le leur.
    [roof_unknown] Les nouvelles mesures de toits sans classe utilisent le nouveau retrait ; les mesures existantes gardent le leur.
    [driver_eye_near] Les nouvelles mesures d’yeux de conducteur côté proche utilisent le nouveau retrait ; les mesures existantes gardent le leur.
    [driver_eye_far] Les nouvelles mesures d’yeux de conducteur côté éloigné utilisent le nouveau retrait ; les mesures existantes gardent le leur.
    [taillight] Les nouvelles mesures de feux arrière utilisent le nouveau retrait ; les mesures existantes gardent le leur.
    [headlight] Les nouvelles mesures de projecteurs utilisent le nouveau retrait ; les mesures existantes gardent le leur.
   *[other] Les nouvelles mesures d’autres cibles utilisent le nouveau retrait ; les mesures existantes gardent le leur.
}

## Contrôles : ce qu’est le retrait

checks-inset-what = Ce qu’est le retrait
checks-inset-title = Ce qu’est le retrait, et pourquoi il compte
checks-inset-plane = Une hauteur se lit là où la ligne de visée coupe le <strong>plan latéral</strong> : le plan vertical qui passe par le contact du pneu avec la chaussée, parallèle au trafic. Un bord de toit ou un œil de conducteur est derrière ce plan, de son <strong>retrait</strong>. Lue sur le plan, une cible plus basse que la caméra semble trop haute, et une cible plus haute, trop basse.
checks-inset-formula = lue − vraie = (H<sub>c</sub> − h) · retrait / (D + retrait)
checks-inset-symbols = H<sub>c</sub> est la hauteur de la caméra, h celle de la cible, D la distance de la caméra au plan latéral. Si caméra et cible sont à la même hauteur, le retrait est sans effet. Chaque hauteur enregistrée en est corrigée ; la hauteur non corrigée est gardée à côté.
checks-missing-inset = Erreur sans correction du retrait
checks-missing-inset-caption = Erreur de hauteur sans correction du retrait, pour une caméra à { $camera_height }
checks-height = Hauteur
checks-inset = Retrait
checks-at = À { $distance }
checks-drawing = Coupe transversale de la route. La caméra vise vers le bas une cible située derrière le plan latéral passant par le pneu ; la ligne de visée coupe ce plan plus haut que la cible.
checks-drawing-camera = caméra
checks-drawing-side-plane = plan latéral
checks-drawing-inset = retrait
checks-drawing-read = lue ici
checks-drawing-target = la cible
checks-drawing-too-high =
    trop
    haut

## Contrôles : le sens de circulation

checks-vehicles-loading = véhicules
checks-no-vehicles-title = Pas encore de véhicules
checks-no-vehicles = La direction du trafic est calculée d’après les pneus des véhicules. Marquez d’abord leurs passages.
checks-mark-passes = Marquer les passages
checks-withdraw = Retirer les pneus
checks-previous = Précédent
checks-next = Suivant
checks-no-pose = Cet enregistrement n’a pas encore de pose de la caméra.
checks-no-pose-link = Mesurer exige la pose de la caméra de cet enregistrement ; <link>calculez-la</link> d’abord.
checks-turned-road = Aperçu de la pose pivotée.
checks-replace = Cliquez à nouveau pour le remplacer.
checks-choose-vehicle = Choisissez un véhicule.
checks-first-tyre = Cliquez là où le premier pneu du côté proche touche la chaussée.
checks-second-tyre = Cliquez là où l’autre pneu du même côté touche la chaussée.
checks-verdict = Conclusion
checks-mean = Moyenne
checks-spread-of-vehicles = Entre véhicules
checks-used-vehicles = Utilisés
checks-used-of = { $count ->
    [one] { NUMBER($count) } véhicule sur { NUMBER($all) }
   *[other] { NUMBER($count) } véhicules sur { NUMBER($all) }
}
checks-turned-from = Cette pose a été pivotée de { $turned } à partir de la pose { $pose }.
value-u = { $value } (u = { $u })
checks-turn-by = Pivoter les axes de la route de { $turn }…
checks-use-before = Utiliser la pose précédente
checks-turned-pose = Pose pivotée
checks-turned-by = Pivotée de { $turn }
checks-turn-no-heights = Aucune hauteur enregistrée n’utilise cette pose.
checks-turn-heights = { $count ->
    [one] { NUMBER($count) } hauteur enregistrée différerait d’au plus { $largest } si elle était repointée. Les valeurs enregistrées ne changent pas.
   *[other] { NUMBER($count) } hauteurs enregistrées différeraient d’au plus { $largest } si elles étaient repointées. Les valeurs enregistrées ne changent pas.
}
checks-differences = Écarts de hauteur
checks-vehicle = Véhicule
checks-turned = Pivotée
checks-turn = Pivoter
checks-turn-done = La pose pivotée vaut pour les nouvelles mesures. Les mesures existantes ne changent pas.
checks-turn-back-done = La pose précédente est à nouveau en vigueur.
checks-heading = Cap
checks-apart = Écartement
checks-two-frames = sur deux images
checks-tyres = pneus du véhicule { $vehicle }
checks-withdrawal = pneus retirés, véhicule { $vehicle }
checks-tyres-none = aucun
checks-tyres-at = image { $frame }, à { $first } et { $second } px

## Mesure : la page

measure-loading = image
measure-none-title = Pas encore d’enregistrement à mesurer
measure-none = Les hauteurs se mesurent sur les images d’un enregistrement. Ajoutez d’abord les vidéos du jour ; elles sont mesurables dès qu’elles sont importées.
measure-add-recordings = Ajouter des enregistrements
measure-last-pass = C’est le dernier passage de la liste.
measure-first-pass = C’est le premier passage de la liste.
measure-all-passes-done = Tous les passages de ce relevé sont mesurés.
measure-other-tab = Ouvert aussi dans un autre onglet. Si les deux le modifient, vous choisirez lequel garder.

## Mesure : les passages

measure-passes = Passages
measure-passes-open = Passages <muted>{ NUMBER($count) } à faire{ $rejected ->
    [0] {""}
    [one] , { NUMBER($rejected) } rejeté
   *[other] , { NUMBER($rejected) } rejetés
}</muted>
measure-passes-show = Afficher
measure-passes-order = Ordre
measure-passes-none = Pas encore de véhicules. Détectez les passages, ou marquez la première image d’un véhicule.
measure-passes-none-in-state = Aucun passage n’est dans cet état.
measure-class-missing = Manque : le retrait du toit et les chiffres par classe en dépendent.
measure-proposals-late = Montrer les propositions
measure-proposals-late-title = Elles sont arrivées après que vous avez commencé : vos touches et vos clics ont gardé leur sens.
measure-progress = { NUMBER($count) } sur { NUMBER($all) }
measure-pass-begins = Le passage commence à cette image
measure-pass-begin = Passage ici
measure-pass-ends = Le passage finit à cette image
measure-pass-end = …finit ici
measure-pass-drop = Annuler le nouveau passage
measure-pass-frames = { $count ->
    [one] { NUMBER($count) } image
   *[other] { NUMBER($count) } images
}
measure-pass-marked = Le passage commence à l’image { $frame } ; allez à sa dernière image et marquez-la aussi.
measure-pass-new = Nouveau passage
measure-pass-new-short = nouveau
measure-pass-found = trouvé
measure-pass-title = Passage { $vehicle } : images { $first_frame } à { $last_frame }
measure-pass-title-more = Passage { $vehicle } : images { $first_frame } à { $last_frame }, { $more }
measure-way-right = vers la droite
measure-way-left = vers la gauche
measure-unconfirmed = trouvé par Sightline, non confirmé
measure-unconfirmed-way = { $way ->
    [right] vers la droite, trouvé par Sightline, non confirmé
   *[left] vers la gauche, trouvé par Sightline, non confirmé
}
measure-pass-menu = Véhicule { $vehicle } : scinder, fusionner, écarter
measure-pass-confirm = { $lighting ->
    [daytime] Confirmer : de jour
   *[low_light] Confirmer : faible luminosité
}
measure-pass-split = Scinder avant cette image
measure-pass-join = Fusionner avec le passage suivant
measure-pass-splitted = Le véhicule { $vehicle } a été scindé à l’image { $frame } ; l’autre partie est le véhicule { $other }.
measure-pass-joined = Le véhicule { $gone } a été fusionné avec le véhicule { $kept }.
measure-pass-no-next = Aucun passage de cet enregistrement ne commence après celui-ci : il n’y a rien à fusionner.
measure-pass-delete-of = Supprimer le passage du véhicule { $vehicle }
measure-pass-delete-title = Supprimer le véhicule { $vehicle } ?
measure-pass-delete-body = { $count ->
    [0] Le véhicule { $vehicle } sera supprimé. Vous pourrez annuler cette suppression.
    [one] Le véhicule { $vehicle } et sa mesure seront supprimés. Vous pourrez annuler cette suppression.
   *[other] Le véhicule { $vehicle } et ses { NUMBER($count) } mesures seront supprimés. Vous pourrez annuler cette suppression.
}
measure-pass-delete = Supprimer le passage
measure-pass-bring-back = Rétablir le passage
measure-pass-kept = Gardé dans ce navigateur ; il sera envoyé au retour de la connexion.
measure-pass-new-frames = images { $first_frame } à { $last_frame }

## Mesure : ce que nomment annuler et rétablir

measure-step-of = { $step }, véhicule { $vehicle }
measure-step-vehicle = données du véhicule { $vehicle }
measure-step-new-pass = nouveau passage { $vehicle }
measure-step-deletion = suppression du véhicule { $vehicle }
measure-step-split = scission du véhicule { $vehicle }
measure-step-joining = fusion des véhicules { $vehicle } et { $next }
measure-step-contact = point de contact
measure-step-snap = accrochage au pneu
measure-snapped = accroché au pneu, u = { $expected_px } px ; { $key } : revenir à votre pointé
measure-step-proposals = propositions confirmées
measure-step-contact-removal = contact retiré
measure-step-move = déplacement d’un point
measure-step-inset = retrait latéral
measure-step-new = { $target ->
    [roof] nouveau toit
    [driver_eye] nouvel œil du conducteur
    [taillight] nouveau feu arrière
    [headlight] nouveau projecteur
   *[other] nouvelle autre cible
}
measure-step-withdrawal = { $target ->
    [roof] toit retiré
    [driver_eye] œil du conducteur retiré
    [taillight] feu arrière retiré
    [headlight] projecteur retiré
   *[other] autre cible retirée
}
measure-step-frame = { $nth ->
    [2] deuxième image
    [3] troisième image
    [4] quatrième image
    [5] cinquième image
    [6] sixième image
    [7] septième image
    [8] huitième image
   *[other] image supplémentaire
}
measure-step-frame-removal = image { $frame } retirée

## Mesure : l’image

viewer-place-here = Placer ici
measure-driver = { $side ->
    [near] conducteur côté proche
    [far] conducteur côté éloigné
   *[unknown] côté du conducteur inconnu
}
measure-find-pose = Calculer la pose de la caméra
measure-no-pose = Pas de pose de la caméra. Calculez-la avant de mesurer.
measure-choose-pass = Choisissez un passage à gauche, ou marquez-en un nouveau avec [ et ].
measure-look-only = Lecture seule. Demandez le rôle d’opérateur à un administrateur.
measure-vehicle-done = Terminé. Touches 1 à 5 : mesurer à nouveau.
measure-next-pass = Passage suivant
measure-choose-target = Choisissez une cible : 1 à 5.
measure-drift = La caméra a bougé de { $moved_px } px après le calcul de la pose. <link>Calculez une nouvelle pose ou décidez</link>
measure-drift-off = La caméra a bougé de { $moved_px } px après le calcul de la pose. Erreur de hauteur : jusqu’à { $off } à { $distance }, différente à d’autres distances. <link>Calculez une nouvelle pose ou décidez</link>
measure-proposal-looking = Recherche de la roue…
measure-proposal-take = { $proposal }. Entrée ou un clic pour l’accepter.
measure-proposal-no-pass = Choisissez d’abord un passage ; un contact pourra alors être proposé.
measure-axes-awaited = chargement des axes…
measure-proposal-no-contact = Commencez d’abord un nouveau point de contact.
measure-proposal-no-pointer = Pointez là où le pneu touche la chaussée, puis demandez une proposition.

## Mesure : ce que Sightline propose de pointer

measure-propose = Proposer des points
measure-propose-title = Propose des points sur chaque passage trouvé de cet enregistrement. Les propositions antérieures sont remplacées ; rien n’est mesuré.
measure-propose-failed = Les propositions ont échoué ; réessayez.
measure-propose-cancelled = Le calcul des propositions pour { $recording } a été annulé ; les antérieures restent.
measure-propose-over = { $recording } : les propositions sont prêtes.
measure-proposed = Proposé, non mesuré : Entrée confirme, la touche d’un point y mène.
measure-proposed-awaited = Proposé, non mesuré : calcul des hauteurs…
measure-proposed-selected = Faites glisser le point ou utilisez les flèches. Entrée confirme tout ; sa touche à nouveau le rejette.
measure-proposed-mark = { $what }, proposé
measure-proposed-title = Propositions
measure-proposed-contact = Contact
measure-proposed-accept = { $count ->
    [0] Confirmer le contact
    [one] Confirmer { NUMBER($count) } cible
   *[other] Confirmer { NUMBER($count) } cibles
}
measure-proposed-accept-title = Enregistre les points proposés comme mesures, en votre nom
measure-proposed-on-frame = Propositions sur l’image { $frame }
measure-proposed-go = Aller à ce point, pour le voir et le déplacer
measure-proposed-expected = u = { $expected_px } px
measure-proposed-expected-title = Incertitude-type attendue de ce point
measure-proposed-doubt = Véhicule { $vehicle } : une hauteur que vous avez confirmée est inhabituelle. Contrôlez-la.
measure-proposed-moved = déplacé par vous
measure-points-set = Points
measure-made = { $made ->
    [snapped] Contact accroché au pneu, cible à la main
    [confirmed] Proposé par Sightline, confirmé
    [moved] Proposé par Sightline, déplacé à la main
   *[clicked] Pointé à la main
}

## Mesure : les mesures d’un véhicule

measure-measurements = Mesures
measure-target = Mesurer : { $target }
measure-target-afresh = Mesurer à nouveau : { $target }
measure-targets-idle = Non demandé dans ce relevé
measure-afresh = { $target ->
    [roof] Toit mesuré à nouveau. La valeur précédente est dans l’historique.
    [driver_eye] Œil du conducteur mesuré à nouveau. La valeur précédente est dans l’historique.
    [taillight] Feu arrière mesuré à nouveau. La valeur précédente est dans l’historique.
    [headlight] Projecteur mesuré à nouveau. La valeur précédente est dans l’historique.
   *[other] Autre cible mesurée à nouveau. La valeur précédente est dans l’historique.
}
measure-show-point = Afficher et sélectionner le point
measure-click = cliquez sur l’image
measure-details-show = { $target ->
    [roof] Afficher les détails du toit
    [driver_eye] Afficher les détails de l’œil du conducteur
    [taillight] Afficher les détails du feu arrière
    [headlight] Afficher les détails du projecteur
   *[other] Afficher les détails de l’autre cible
}
measure-details-hide = { $target ->
    [roof] Masquer les détails du toit
    [driver_eye] Masquer les détails de l’œil du conducteur
    [taillight] Masquer les détails du feu arrière
    [headlight] Masquer les détails du projecteur
   *[other] Masquer les détails de l’autre cible
}
measure-discard = Abandonner
measure-doubt = { $kind ->
    [above_roof] C’est plus haut que le toit ({ $low }) : vérifiez que le point est sur le bon élément.
    [below_lamp] Le projecteur est plus haut ({ $low }) : vérifiez que le point est sur l’œil du conducteur.
    [far_from_maker] La hauteur du constructeur est { $low } : vérifiez les points, la marque et le modèle.
   *[outside_class] Les véhicules de cette catégorie sont entre { $low } et { $high } : vérifiez les points et la catégorie.
}
measure-not-yet-saved = pas encore enregistré…
measure-not-stored = non enregistré
measure-click-again = Repointez-la.
measure-click-again-key = Repointez-la ({ $key }).
measure-no-way-back = Impossible d’annuler cette action.
measure-clicked-on = pointé sur l’image { $frame }
measure-contact = Contact
measure-point = Cible
measure-distance = Distance
measure-lateral = Position latérale du pneu, depuis la mire
measure-along = Position longitudinale du pneu, depuis la mire
measure-without-inset = Hauteur non corrigée (retrait = 0)
measure-withdraw = Retirer
measure-px = { $across_px }, { $down_px } px
measure-inset = Retrait
measure-inset-u = u
measure-estimate = estimation
measure-inset-solved = Non utilisé : calculé d’après plusieurs images
measure-inset-what = distance latérale du plan latéral du véhicule à la cible
measure-inset-as-survey = Revenir à la valeur du relevé ({ $inset }, u = { $u_inset })
measure-inset-side = Côté du conducteur
measure-unseen = Non visible : { $why }.
measure-unseen-back = Déclarer visible
measure-unseen-ask = Non visible…
measure-unseen-why = { $target ->
    [roof] Pourquoi le toit n’est-il pas visible ?
    [driver_eye] Pourquoi l’œil du conducteur n’est-il pas visible ?
    [taillight] Pourquoi le feu arrière n’est-il pas visible ?
    [headlight] Pourquoi le projecteur n’est-il pas visible ?
   *[other] Pourquoi n’est-ce pas visible ?
}
measure-side-unknown = inconnu
measure-side-as-survey = valeur du relevé
measure-side-from = { $from ->
    [said] indiqué pour ce véhicule
    [direction] { $direction ->
        [right] va vers la droite
       *[left] va vers la gauche
    }, volant { $steering ->
        [right] à droite
       *[left] à gauche
    }
    [place] sens inconnu : vus du terre-plein central, tous vont dans le même sens
    [undirected] sens inconnu : la hauteur de l’œil ne peut pas être calculée ; indiquez ici le côté, proche ou éloigné, ou le sens du véhicule
   *[unknown] inconnu : la hauteur de l’œil ne peut pas être calculée ; indiquez-le ici pour ce véhicule, ou sous <link>Paramètres</link> pour tous
}
measure-inset-roof = Point du toit
measure-inset-needs-class = Choisissez la classe : le retrait d’un toit en dépend.
measure-inset-now = retrait { $inset } (u = { $u_inset }), estimation

## Mesure : plusieurs images

measure-second-looking = Recherche de la meilleure deuxième image…
measure-second-hint = { $nth ->
    [2] Deuxième image
    [3] Troisième image
    [4] Quatrième image
    [5] Cinquième image
    [6] Sixième image
    [7] Septième image
    [8] Huitième image
   *[other] Image supplémentaire
} : { $what ->
    [elsewhere] allez à une autre image du passage
    [contact] cliquez sur le même contact du pneu
    [roof] cliquez sur le même point du toit
    [driver_eye] cliquez sur le même point de l’œil du conducteur ; s’il est caché, allez à une autre image
    [taillight] cliquez sur le même point du feu arrière
    [headlight] cliquez sur le même point du projecteur
   *[other] cliquez sur le même point de l’autre cible
}
measure-second-hint-care = { $hint }. { $care }
measure-second-nothing-yet = Mesurez d’abord une cible. Vous pourrez ensuite ajouter une deuxième image.
measure-second-no-use = Une deuxième image n’apporte rien.
measure-second-none = { $target } : { $reason }
measure-second-clicked-already = Vous avez déjà utilisé cette image. Choisissez-en une autre.
measure-second-expected = Attendu ici
measure-second-expected-at = à { $speed }
measure-frames-said = { $count ->
    [one] D’après { NUMBER($count) } image
   *[other] D’après { NUMBER($count) } images
}
measure-frames-said-inset = { $count ->
    [one] D’après { NUMBER($count) } image ; retrait { $inset } (u = { $u_inset })
   *[other] D’après { NUMBER($count) } images ; retrait { $inset } (u = { $u_inset })
}
measure-whole-nothing-yet = Mesurez d’abord une cible. Elle peut ensuite être suivie sur le passage.
measure-whole-looking = Suivi des points sur le passage…
measure-whole-heading = Passage entier : pas encore enregistré
measure-whole-height = Hauteur
measure-whole-frames = Images
measure-whole-frames-used = { $used } sur { $all } utilisées
measure-whole-speed = Vitesse
measure-whole-wheelbase = Empattement
measure-whole-dropped = { $count ->
    [one] { NUMBER($count) } point exclu : { $reason }
   *[other] { NUMBER($count) } points exclus : { $reason }
}
measure-whole-look = { $count ->
    [one] { NUMBER($count) } point suivi. Parcourez les images et vérifiez qu’il reste en place.
   *[other] { NUMBER($count) } points suivis. Parcourez les images et vérifiez qu’ils restent en place.
}
measure-whole-keep = Enregistrer cette hauteur
measure-whole-leave = Annuler
measure-whole-said = D’après le passage entier ; retrait { $inset } (u = { $u_inset })
measure-whole-follow = Suivre sur le passage
measure-whole-go = Suit le contact et la cible sur les images du passage. Rien n’est enregistré avant que vous n’enregistriez la hauteur.
measure-step-pass = passage entier
measure-followed-mark = { $point ->
    [contact] contact suivi
    [second_contact] second pneu suivi
   *[target] cible suivie
}
measure-followed-frame = { $used ->
    [yes] Image { $frame } : contact et cible ont été suivis
   *[no] Image { $frame } : contact ou cible a été exclu
}
measure-frame = Image { $frame }
measure-frame-first = première
measure-frame-remove = Retirer l’image { $frame }
measure-frame-remove-this = Retirer cette image
measure-frame-removed = { $count ->
    [one] Image { $frame } retirée. Reste { NUMBER($count) } image.
   *[other] Image { $frame } retirée. Restent { NUMBER($count) } images.
}
measure-one-frame = Une image
measure-all-frames = { $count ->
    [one] { NUMBER($count) } image
   *[other] { NUMBER($count) } images
}
measure-gain-looking = { $which ->
    [second] Recherche de la meilleure deuxième image…
   *[another] Recherche de la meilleure image à ajouter…
}
measure-gain = { $which ->
    [second] Deuxième image, U95 : { $U95_now } → { $U95_then }
   *[another] Une image de plus, U95 : { $U95_now } → { $U95_then }
}
measure-gain-go = Aller à l’image { $frame } et cliquer sur les deux mêmes points

## Mesure : le véhicule

measure-vehicle = Véhicule
measure-vehicle-number = Véhicule { $vehicle }
measure-vehicle-none = Choisissez un passage à gauche. Son véhicule et ses mesures apparaissent ici.
measure-save-again = Réenregistrer
measure-record = Fiche du véhicule
measure-facts-of = données du véhicule { $vehicle }
recent-models-title = Modèles récents
recent-models-taken = Marque et modèle : { $model }
recent-models-gone = { $model } n’est plus dans le catalogue.
which-model-title = Modèles qui conviennent
which-model-cannot = { $model } ne convient pas : { $differences } (mesuré moins catalogue). Si le modèle était le bon, de tels écarts auraient une probabilité de { $p } ; la limite est { $limit }.
which-model-ranked = Classés par { $sizes }. Les hauteurs mesurées ne servent pas au classement : elles seront comparées au modèle.
which-model-by-name = Aucune longueur de ce véhicule n’est mesurée : les modèles de sa catégorie viennent d’abord, puis l’ordre alphabétique. Pointez les deux pneus (Contrôles, Direction) pour classer par empattement.
which-model-shown = Les { $shown } premiers sur { NUMBER($count) } sont affichés.
which-model-left-out = { $count ->
    [one] 1 modèle qui ne convient pas aux dimensions mesurées n’est pas affiché.
   *[other] { NUMBER($count) } modèles qui ne conviennent pas aux dimensions mesurées ne sont pas affichés.
}
model-chosen-by-size = Le modèle a été choisi d’après ses dimensions ({ $sizes }). Ses hauteurs ne servent pas de références tant que personne n’a confirmé le modèle sur le véhicule.
model-chosen-see = Confirmer le modèle
model-chosen-seen = Le modèle a été choisi d’après ses dimensions ({ $sizes }), puis confirmé sur le véhicule.
model-chosen-word-size = d’après ses dimensions
model-chosen-word-seen = confirmé sur le véhicule
which-model-size-height = toit
which-model-size-length = longueur
which-model-size-width = largeur
which-model-size-wheelbase = empattement
which-model-size-taillight = feu arrière
which-model-size-headlight = projecteur
measure-makers-height = Hauteur du constructeur
measure-makers-height-u = Incertitude-type
measure-year-problem = Saisissez une année de 1885 à { $most }.
measure-span = Images du passage
measure-span-first = Première
measure-span-best = Meilleure
measure-span-last = Dernière
measure-span-first-here = Début ici
measure-span-best-here = Choisir
measure-span-last-here = Fin ici
measure-span-elsewhere = Un autre enregistrement est ouvert.
measure-span-frame-problem = Saisissez un numéro d’image.
measure-span-order = { $first_frame } est après { $last_frame }.
measure-span-choose = Choisissez de { $first_frame } à { $last_frame }.
measure-span-move-best = Déplacez d’abord la meilleure ({ $best_frame }).

## Mesure : données d’un véhicule, et deux personnes qui ont modifié la même

measure-field-first_frame = Première image
measure-field-best_frame = Meilleure image
measure-field-last_frame = Dernière image
measure-field-make = Marque
measure-field-model = Modèle
measure-field-year = Année
measure-field-model_chosen_by = Choix du modèle
measure-field-model_sizes = Dimensions qui ont servi à choisir le modèle
measure-field-category = Catégorie
measure-field-manufacturer_height_m = Hauteur du constructeur
measure-field-u_manufacturer_height_m = u de la hauteur du constructeur
measure-field-height_source = Source de la hauteur
measure-field-known_driver_eye_m = Hauteur connue de l’œil du conducteur
measure-field-u_known_driver_eye_m = u de la hauteur connue de l’œil du conducteur
measure-field-known_driver_eye_source = Source de la hauteur connue de l’œil du conducteur
measure-field-known_taillight_m = Hauteur connue du feu arrière
measure-field-u_known_taillight_m = u de la hauteur connue du feu arrière
measure-field-known_taillight_source = Source de la hauteur connue du feu arrière
measure-field-known_headlight_m = Hauteur connue du projecteur
measure-field-u_known_headlight_m = u de la hauteur connue du projecteur
measure-field-known_headlight_source = Source de la hauteur connue du projecteur
measure-field-known_other_m = Hauteur connue du repère
measure-field-u_known_other_m = u de la hauteur connue du repère
measure-field-known_other_source = Source de la hauteur connue du repère
measure-field-check_target = Cible de contrôle
measure-check-target-yes = oui
measure-check-target-no = non
measure-check-target-mark = cible de contrôle
measure-known-title = Hauteurs connues
measure-known-help = Hauteurs de l’œil, des feux ou d’un repère, mesurées au mètre ruban ou d’après une fiche technique. Les erreurs sont calculées par rapport à elles. La hauteur du toit se saisit au-dessus.
measure-known-some = { $count ->
    [one] 1 connue
   *[other] { NUMBER($count) } connues
}
measure-known-u = u
measure-known-source = Source
measure-known-mark = Repère
measure-check-target-help = Un jalon à repères, ou une voiture aux hauteurs mesurées au mètre ruban, qui passe pour contrôler la mesure ; sur un jalon, mettez le retrait de chaque hauteur à 0. Elle a sa propre ligne dans les tableaux d’erreurs et est exclue des distributions, des quotas et du taux de réponse.
measure-check-target-empty = Une cible de contrôle a besoin d’une hauteur connue. Saisissez celle du toit au-dessus, ou une autre ici.
measure-field-lighting = Luminosité
measure-field-direction = Sens
measure-field-driver_side = Côté du conducteur
measure-field-roof_not_visible = Toit non visible
measure-field-driver_eye_not_visible = Œil du conducteur non visible
measure-field-taillight_not_visible = Feu arrière non visible
measure-field-headlight_not_visible = Projecteur non visible
measure-field-discarded = Passage
measure-field-notes = { field-notes }
measure-in-sample = dans l’échantillon
measure-out-of-sample = hors échantillon, selon la règle du relevé
measure-discard-measured = Retirez ses mesures pour l’écarter.
measure-fact = { $field ->
    [first_frame] première image { $value }
    [best_frame] meilleure image { $value }
    [last_frame] dernière image { $value }
    [make] marque { $value }
    [model] modèle { $value }
    [year] année { $value }
    [model_chosen_by] choix du modèle : { $value }
    [model_sizes] modèle choisi d’après : { $value }
    [category] catégorie { $value }
    [manufacturer_height_m] hauteur du constructeur { $value }
    [u_manufacturer_height_m] u de la hauteur du constructeur { $value }
    [height_source] source de la hauteur { $value }
    [known_driver_eye_m] hauteur connue de l’œil du conducteur { $value }
    [u_known_driver_eye_m] u de la hauteur connue de l’œil du conducteur { $value }
    [known_driver_eye_source] source de la hauteur connue de l’œil du conducteur { $value }
    [known_taillight_m] hauteur connue du feu arrière { $value }
    [u_known_taillight_m] u de la hauteur connue du feu arrière { $value }
    [known_taillight_source] source de la hauteur connue du feu arrière { $value }
    [known_headlight_m] hauteur connue du projecteur { $value }
    [u_known_headlight_m] u de la hauteur connue du projecteur { $value }
    [known_headlight_source] source de la hauteur connue du projecteur { $value }
    [known_other_m] hauteur connue du repère { $value }
    [u_known_other_m] u de la hauteur connue du repère { $value }
    [known_other_source] source de la hauteur connue du repère { $value }
    [check_target] cible de contrôle : { $value }
    [lighting] luminosité : { $value }
    [direction] va { $value }
    [driver_side] conducteur { $value }
    [roof_not_visible] toit non visible : { $value }
    [driver_eye_not_visible] œil du conducteur non visible : { $value }
    [taillight_not_visible] feu arrière non visible : { $value }
    [headlight_not_visible] projecteur non visible : { $value }
    [discarded] { $value }
   *[notes] notes { $value }
}
measure-fact-empty = vide
measure-deleted = supprimé
measure-merged = { $problem } Vos modifications portent sur d’autres champs : les deux sont gardées.
measure-conflict = Modifié par un autre utilisateur
measure-conflict-kept = Les deux versions sont gardées jusqu’à votre choix.
measure-conflict-mine = la vôtre : { $value }
measure-conflict-theirs = l’autre : { $value }
measure-conflict-save = Enregistrer celle-ci
measure-conflict-changed = { $person } a modifié ce véhicule le { $when }.
measure-conflict-measured = { $person } a mesuré cette cible le { $when }.
measure-conflict-withdrawn = { $person } a retiré cette mesure le { $when }.
measure-conflict-height-theirs = L’autre
measure-conflict-height-mine = La vôtre
measure-conflict-keep-theirs = Garder l’autre
measure-conflict-save-mine = Enregistrer la mienne comme révision
measure-conflict-withdraw = Retirer la mesure
measure-conflict-somebody = un autre utilisateur

## Vérification : la page

review-loading = file des mesures
review-back-to-frame = Revenir à l’image { $frame }
review-none-in-state-title = Rien dans cet état
review-none-in-state = Choisissez un autre état dans la liste à gauche.
review-all-done-title = Tout est vérifié
review-all-done = Chaque mesure a une décision. Les mesures nouvelles ou corrigées apparaissent ici d’elles-mêmes.
review-to-export = Aller à l’archive
review-none-title = Rien à vérifier pour l’instant
review-none = Les mesures apparaissent ici dès qu’un opérateur les a pointées.
review-to-measure = Aller à la mesure
review-other-point = Choisir l’autre point
review-other-frame = Pas l’image mesurée
review-fix-hint = Faites glisser un point, ou appuyez sur { $key } et déplacez-le avec les flèches. Entrée enregistre, Échap abandonne.

## Vérification : la file

review-queue = File
review-queue-title = Vérification <muted>{ NUMBER($count) } à vérifier</muted>
review-queue-end = C’est la fin de la file.
review-queue-start = C’est le début de la file.
review-queue-more = Afficher plus
review-show = Afficher
review-state-to_review = À vérifier
review-state-rejected = Rejetées
review-state-accepted = Validées
review-state-fixed = Corrigées
review-state-all = Toutes
review-counts = validées : { NUMBER($accepted) }, rejetées : { NUMBER($rejected) }, sur { NUMBER($count) }
review-counts-of-scans = { $count ->
    [one] (dont 1 de balayages)
   *[other] (dont { NUMBER($count) } de balayages)
}
review-mine = la mienne
review-line = balayage
review-verdict-of = décision ({ $target }, véhicule { $vehicle })
review-verdict-reason = { $verdict } : { $reason }
review-verdict-by = { $verdict } par { $person }
review-verdict-none = aucune décision
review-verdict-kept = La décision est gardée dans ce navigateur et sera envoyée au retour de la connexion.

## Vérification : repointer avant de voir les points

review-plan = { $one_in ->
    [0] Contrôle en aveugle : désactivé.
    [1] Contrôle en aveugle : chaque mesure est pointée avant d’être montrée.
   *[other] Contrôle en aveugle : 1 mesure sur { $one_in } est pointée avant d’être montrée.
 }
review-plan-name = Contrôle en aveugle
review-plan-choose = Contrôle en aveugle, pour tous les vérificateurs de ce relevé
review-plan-choice = { $one_in ->
    [0] aucune
    [1] toutes
   *[other] 1 sur { $one_in }
}
review-blind-click = à repointer
review-blind-title = Contrôle en aveugle : pointez d’abord vous-même
review-blind-contact = Cliquez sur le contact du pneu, puis sur la cible. Les points et la hauteur s’affichent ensuite, à côté des vôtres.
review-blind-target = Maintenant la cible. Échap retire le contact.
review-blind-why = Des pointés indépendants, en aveugle, montrent la répétabilité des mesures. Ils sont tirés au sort. Si l’un est impossible, rejetez la mesure avec le motif.
blind-kept = Votre second pointé est gardé dans ce navigateur et sera envoyé au retour de la connexion.
review-again = Repointage
review-again-you = <strong>Vous</strong> l’avez repointée : <height>{ $height }</height>
review-again-person = <strong>{ $person }</strong> l’a repointée : <height>{ $height }</height>
review-again-somebody = <strong>Un autre utilisateur</strong> l’a repointée : <height>{ $height }</height>
review-again-take-back = Annuler
review-again-agree = Concordent : écart { $apart }, limite { $expected }
review-again-differ = Divergent : écart { $apart }, limite { $expected }
review-again-not-compared = Non comparées

## Vérification : ce que l’on sait d’une mesure

review-measurement = Mesure
review-facts = Données et historique
review-contact = contact
review-pixels = { $point ->
    [contact] Pixels autour du point de contact
    [roof] Pixels autour du point du toit
    [driver_eye] Pixels autour du point de l’œil du conducteur
    [taillight] Pixels autour du point du feu arrière
    [headlight] Pixels autour du point du projecteur
   *[other] Pixels autour du point de l’autre cible
}
review-vehicle = Véhicule
review-vehicle-unknown = inconnu
review-manufacturer-height = Hauteur du constructeur
review-lighting = Luminosité
review-frame-at = { $frame }, { $time }
review-further-frames = Autres images
review-distance = Distance
review-inset = Retrait
review-inset-estimate = { $inset } (u = { $u_inset }, estimation)
review-points-set = Points
review-made-by = { $made ->
    [snapped] contact accroché au pneu, cible pointée par { $person }, { $time }
    [confirmed] proposés, confirmés par { $person }, { $time }
    [moved] proposés, déplacés par { $person }, { $time }
   *[clicked] pointés par { $person }, { $time }
}

## Vérification : la décision

review-look-only = Lecture seule. Les vérificateurs décident.
review-own = Vous avez fait cette mesure : une autre personne la vérifie.
review-pose-changed = L’enregistrement a une autre pose de la caméra depuis cette mesure ; la correction est calculée avec la nouvelle.
review-fix-save = Enregistrer la correction
review-fix-nothing = Rien n’a changé. Déplacez d’abord un point, ou validez la mesure.
review-fix-leave = Annuler
review-fix-mine = Utiliser mes points
review-reopen = Rouvrir
review-reject-why = Pourquoi est-elle rejetée ?
review-reject-words = En vos propres termes
review-reason-contact = Le contact n’est pas là où le pneu touche la chaussée.
review-reason-point = Le point de la cible est à côté de l’élément visé.
review-reason-frame = Une autre image le montre mieux.
review-reason-hidden = L’élément visé est masqué.
review-reason-wrong = Mauvais véhicule ou mauvaise cible.
review-reason-side = Le conducteur est assis de l’autre côté.
review-step-verdict = décision ({ $target ->
    [roof] toit
    [driver_eye] œil du conducteur
    [taillight] feu arrière
    [headlight] projecteur
   *[other] autre cible
}, véhicule { $vehicle })
review-step-overtaken = Rien n’a été modifié : depuis, cette mesure a été retirée ou changée, ou a reçu une autre décision.
review-step-not-again = Rien n’a été modifié : l’annulation ne rétablit ni une correction ni la décision d’une autre personne ; acceptez la mesure si elle est juste, sinon rejetez-la.
review-error = Erreur de hauteur
review-side = Côté du conducteur
review-signs = <strong>À contrôler de près :</strong> { $signs }
review-sign = { $sign ->
    [large_u] incertitude élevée
    [unusual] hauteur inhabituelle dans ce relevé
    [far_from_maker] loin de la hauteur du constructeur
   *[new_operator] opérateur ayant peu de mesures
}
review-own-waiting = { $count ->
    [one] { NUMBER($count) } de vos mesures attend un autre vérificateur.
   *[other] { NUMBER($count) } de vos mesures attendent un autre vérificateur.
}
review-neighbours = Images voisines
review-neighbour = Image { $frame }

## Répétitions : la page

repeats-lead = { $people ->
    [1] Mesures répétées en aveugle des mêmes cibles : variation chez un même opérateur (répétabilité). La variation entre opérateurs (reproductibilité) sera connue quand un second les répétera.
   *[other] Mesures répétées en aveugle des mêmes cibles : variation chez un même opérateur (répétabilité) et entre opérateurs (reproductibilité).
}
repeats-loading = répétabilité
repeats-not-compared = { $count ->
    [one] { NUMBER($count) } répétition est exclue
   *[other] { NUMBER($count) } répétitions sont exclues
} : la pose de la caméra ou le retrait a changé, ou aucune hauteur n’a pu être calculée.
repeats-click-mine = Répéter 10 de mes mesures
repeats-click-anybodys = Répéter 10 mesures, tous opérateurs
repeats-none-title = Pas encore de mesures répétées
repeats-none = { $one_in ->
    [0] Répétez ici dix mesures tirées au hasard, ou activez les contrôles en aveugle sous Vérification.
    [1] Les contrôles en aveugle sont actifs : chaque mesure est répétée sous Vérification. Dix mesures tirées au hasard peuvent aussi être répétées ici.
   *[other] Les contrôles en aveugle sont actifs : 1 mesure sur { $one_in } est répétée sous Vérification. Dix mesures tirées au hasard peuvent aussi être répétées ici.
} Après dix répétitions de vos propres mesures, votre propre incertitude de pointé peut remplacer la valeur par défaut de 1 px. Les répétitions des mesures d’autrui montrent la variation entre opérateurs.
repeats-no-result = Les répétitions sont gardées à part et ne changent pas les résultats.
repeats-to-review = Aller à la vérification
repeats-target = Cible
repeats-items = { $count ->
    [one] { NUMBER($count) } mesure
   *[other] { NUMBER($count) } mesures
}

## Répétitions : le tableau des cibles

repeats-targets-title = Hauteurs, par cible
repeats-targets-note = Écarts-types avec leurs intervalles de confiance à 95 %
repeats-targets-help = Les valeurs regroupent toutes les distances ; la dispersion en millimètres croît avec la distance. Les répétitions sur la même image partagent les erreurs d’objectif, de pose, de mire et de retrait : seule la composante de pointé du bilan d’incertitude est comparée. Pour inclure les autres composantes, répétez sur une autre image.
repeats-clicked-again = Mesures répétées
repeats-same-person = Répétabilité (s)
repeats-another-frame = Répétabilité, autre image
repeats-another-person = Reproductibilité (entre opérateurs)
repeats-claimed = Incertitude de pointé, indiquée
repeats-seen = Incertitude de pointé, observée
repeats-all-targets = Toutes les cibles
repeats-people-differ = Interaction opérateur × véhicule significative (p < 0,05) ; elle est comprise dans la répétabilité.
repeats-ratio = × { $ratio } ({ $low } à { $high })
repeats-more = plus qu’indiqué
repeats-less = moins qu’indiqué
repeats-as = comme indiqué

## Répétitions : le tableau des personnes

repeats-people-title = Pointés, par opérateur
repeats-people-note = Écart-type de chaque coordonnée d’un pointé, d’après ses propres répétitions
repeats-person = Opérateur
repeats-own = Ses répétitions
repeats-contact = Contact
repeats-height = Hauteur
repeats-against-others = Écart moyen aux autres opérateurs
repeats-sigma = Incertitude de pointé utilisée
repeats-sigma-usual = 1 px (par défaut)
repeats-sigma-own = { $sigma_px } px (d’après les répétitions)
repeats-sigma-from = { $count ->
    [one] d’après { NUMBER($count) } répétition, choix de { $person }
   *[other] d’après { NUMBER($count) } répétitions, choix de { $person }
}
repeats-sigma-use = Utiliser { $sigma_px } px
repeats-sigma-use-title = { $count ->
    [one] D’après les hauteurs de { NUMBER($count) } répétition ; les mesures existantes gardent la valeur précédente
   *[other] D’après les hauteurs de { NUMBER($count) } répétitions ; les mesures existantes gardent la valeur précédente
}
repeats-sigma-needs = Il faut 10 répétitions de ses mesures
repeats-sigma-back = Revenir à 1 px

## Répétitions : la figure des écarts

anchoring-title = Effet de l’affichage des propositions
anchoring-shown = Propositions affichées
anchoring-free = Propositions masquées
anchoring-shift = Décalage dû aux propositions
anchoring-goal = Objectif : moins de { $goal }
anchoring-vehicles = { $count ->
    [one] { NUMBER($count) } véhicule
   *[other] { NUMBER($count) } véhicules
}
anchoring-verdict = { $verdict ->
    [met] atteint : tout l’IC à 95 % est dans la limite
    [missed] manqué : tout l’IC à 95 % est hors de la limite
   *[undecided] indécis : mesurez plus de véhicules aux propositions masquées
}
anchoring-plan = { $one_in ->
    [0] propositions toujours affichées
   *[other] propositions masquées pour 1 véhicule sur { $one_in }
}
anchoring-plan-choose = Part des véhicules aux propositions masquées, tirés au sort par le serveur
anchoring-help = Pour chaque véhicule : hauteur enregistrée moins hauteur des points proposés, sur la même image. Le serveur tire au sort les véhicules dont les propositions sont masquées : les deux groupes ne diffèrent que par l’affichage des propositions. Le décalage est l’augmentation moyenne des hauteurs enregistrées quand les propositions sont affichées (IC à 95 %, Welch). Les hauteurs mesurées par une même personne ne sont pas indépendantes : le résultat vaut pour les opérateurs qui ont mesuré ici. Il ne dit pas si les propositions sont exactes.
anchoring-counts = Propositions affichées : { $confirmed } hauteurs confirmées, { $moved } déplacées et { $afresh } pointées à la main ; toutes sont comprises.
repeats-differences-title = Seconde hauteur moins la première, selon leur moyenne
repeats-differences-note = Les barres représentent l’incertitude élargie de l’écart (U95). Environ 95 % des barres devraient contenir zéro.
repeats-differences-label = { $count ->
    [one] Seconde hauteur moins la première en { $small } selon leur moyenne en { $unit }, { NUMBER($count) } répétition
   *[other] Seconde hauteur moins la première en { $small } selon leur moyenne en { $unit }, { NUMBER($count) } répétitions
}
repeats-differences-x = Moyenne des deux hauteurs ({ $unit })
repeats-differences-y = Écart ({ $unit })

## Repointer : des mesures refaites, sans leurs points

again-loading = répétitions en aveugle
again-place = <strong>{ $at } sur { $of }</strong> <muted>véhicule { $vehicle }, { $target }</muted>
again-stored = { $count ->
    [one] { NUMBER($count) } répétition enregistrée
   *[other] { NUMBER($count) } répétitions enregistrées
}
again-stop = Arrêter
again-undo = Annuler la dernière répétition
again-undo-clicks = seconds pointés
again-undo-skip = mesure passée
again-skip = Passer
again-results = Voir les résultats
again-back-to-frame = Revenir à l’image { $frame }
again-last-title = Plus de mesures à répéter
again-last = Chacune est enregistrée comme répétition : les répétitions sont gardées à part et ne changent pas les résultats.
again-none-own-title = Vous n’avez pas encore de mesures
again-none-title = Pas encore de mesures
again-none-own = Mesurez d’abord quelques véhicules de ce relevé. Vous pourrez ensuite répéter vos propres mesures.
again-none = Mesurez d’abord quelques véhicules. Leurs mesures pourront ensuite être répétées.
again-to-measure = Aller à la mesure
scans-lane-needs-boundaries = Le véhicule n’a pas encore été mesuré, il n’a donc pas de voie ; placez d’abord ses bornes.

## Balayages : la page

scans-lead = Deux caméras linéaires séparées d’une base connue donnent vitesse, longueur, accélération et intervalles, avec l’image de chaque véhicule.
scans-loading = balayages
scan-live = Cette partie du flux est encore en cours d’enregistrement ; son image sera disponible à la fin.
live-lead = Les véhicules vus par les caméras linéaires, et l’état des caméras.
live-loading = flux en direct
live-none-title = Pas encore de flux
live-none-pipe = Mettez dans la commande les pixels par ligne, la base (m) et la cadence de lignes (Hz) de vos caméras. Sur l’ordinateur des caméras, envoyez-lui les lignes de l’enregistreur :
live-none-file = ou suivez un fichier écrit par l’enregistreur :
live-none-cameras = ou lisez deux caméras GigE Vision (avec Aravis) :
live-source-piped = Lignes reçues par un tube
live-since = Depuis { $time }
live-state-running = en cours
live-state-silent = sans signal
live-state-ended = terminé
live-state-stopped = interrompu
live-stopped = Le flux s’est interrompu sans se terminer. Dernier contact : { $time }. Les véhicules vus jusque-là sont enregistrés. Les lignes déjà prises sont sur son ordinateur : relancez-y la même commande pour reprendre.
live-silent = Dernier contact : { $ago }. Vérifiez son ordinateur ; la même commande reprend le flux.
live-earlier = Parties antérieures :
live-time = Enregistré
live-lines = Lignes
live-lost = Lignes perdues (1 / 2)
live-light = Luminosité de la chaussée
live-saturated = Saturé
live-clock = Retard
live-waiting = En attente
live-memory = Mémoire
live-flow = Véhicules par minute
live-flow-last = { $time } : { $vehicles }
live-flow-none = pas encore de minute entière
live-flow-minute = { $time } : { $vehicles ->
    [one] { $vehicles } véhicule
   *[other] { $vehicles } véhicules
}
live-flow-part = { $time } : { $vehicles ->
    [one] { $vehicles } véhicule
   *[other] { $vehicles } véhicules
}, minute observée en partie
live-vehicles = Derniers véhicules
live-no-vehicles = Pas encore de véhicules
live-picture-later = Les images des véhicules sont disponibles quand cette partie du flux est terminée et importée.
scans-add = Ajouter un balayage
scans-all = Tous les balayages
scans-no-such-lane = Le dispositif n’a pas de voie { $lane } ; choisissez une de ses voies.
scans-none-title = Pas encore de balayages
scans-none = Un opérateur peut envoyer ici les bandes des deux caméras.
scans-delete-title = Supprimer { $scan } ?
scans-delete-what = Les deux bandes et les véhicules qui y ont été trouvés seront supprimés. Un balayage dont des véhicules ont été modifiés ou vérifiés ne peut pas être supprimé.
scans-delete = Supprimer le balayage
scans-delete-one = Supprimer { $scan }
scans-deleted = { $scan } a été supprimé.
scans-read-again = Importer à nouveau
scans-not-read = Les bandes n’ont pas pu être importées.
scans-rig = Dispositif, et estimations d’après le trafic
scans-rig-change = Modifier le dispositif…
scans-open = Ouvrir
scans-fact-lines = { $lines ->
    [one] { $lines } ligne de { $rows_px } pixels
   *[other] { $lines } lignes de { $rows_px } pixels
}
scans-start-words = { $start } (u = { $u_s } s)
scans-start-unknown = Début inconnu : aucun véhicule n’a d’heure.
scans-start-edit-of = Modifier le début de { $recording }
scans-start-line = Première ligne, heure locale
scans-start-hint = D’après l’horloge de l’enregistreur, ou une montre tenue devant la caméra 1 et vos notes.
scans-start-from-video = La vidéo source commence { $time } (début confirmé, sinon celui qu’indique son fichier).
scans-start-u = Incertitude-type u
scans-start-u-hint = Commune à tous les véhicules. Par exemple 1 pour une montre lue à l’œil, 0,001 pour des lignes horodatées par GPS ou PTP.
scans-start-u-problem = Saisissez l’incertitude-type du début en secondes, plus de 0.
scans-fact-baseline = base { $baseline }
scans-fact-rate = { $rate_hz } lignes/s
scans-fact-video = extrait d’une vidéo aux { $along ->
    [columns] colonnes
   *[rows] rangées
} { $cut_1_px } et { $cut_2_px }
scans-count-none = véhicules pas encore détectés
scans-count-vehicles = { $count ->
    [one] { NUMBER($count) } véhicule
   *[other] { NUMBER($count) } véhicules
}
scans-count-to-review = { NUMBER($count) } à vérifier
scans-count-accepted = { $count ->
    [one] { NUMBER($count) } validé
   *[other] { NUMBER($count) } validés
}
scans-count-rejected = { $count ->
    [one] { NUMBER($count) } rejeté
   *[other] { NUMBER($count) } rejetés
}
scans-count-not-measurable = { $count ->
    [one] { NUMBER($count) } non mesurable
   *[other] { NUMBER($count) } non mesurables
}
scans-count-heights = { $count ->
    [one] { NUMBER($count) } hauteur
   *[other] { NUMBER($count) } hauteurs
}
scans-count-heights-to-review = { $count ->
    [one] { NUMBER($count) } hauteur à vérifier
   *[other] { NUMBER($count) } hauteurs à vérifier
}

## Balayages : ce qu’un balayage ne peut pas mesurer

scans-limits = Ce qu’un balayage ne peut pas mesurer
scans-limit-opposing = Sens opposé
scans-limit-opposing-why = Un véhicule qui atteint d’abord la caméra 2 est mesuré en échangeant le rôle des caméras ; son sens est affiché et exporté, et sa vitesse, son heure et ses intervalles sont ceux devant la caméra 1, comme pour tous. Deux véhicules qui se croisent devant les caméras partagent leurs lignes et ne sont pas mesurés.
scans-limit-abreast = Masquage par des véhicules côte à côte
scans-limit-abreast-why = Deux véhicules qui se masquent partagent leurs lignes : aucun n’a un avant et un arrière à lui. Ils ne sont mesurables que s’ils passent séparément : choisissez une voie plus éloignée ou une vue plus plongeante.
scans-limit-slow = À l’arrêt, en marche arrière ou très lents
scans-limit-slow-why = Une bande enregistre le temps, pas la distance. Un véhicule arrêté répète la même ligne, et l’ajustement suppose une accélération constante : la circulation en accordéon n’est pas mesurable.
scans-limit-cut = Coupés, ou lignes perdues
scans-limit-cut-why = Un véhicule coupé par le début ou la fin de l’enregistrement n’a pas d’avant ou pas d’arrière. Là où l’enregistreur a perdu des lignes, l’axe du temps de la bande est faux.
scans-limit-distance = Véhicules à une autre distance
scans-limit-distance-why = Si les plans de balayage ne sont pas tout à fait parallèles, la base varie avec la distance, ce que le trafic seul ne peut révéler. Indiquez l’incertitude de la divergence et la distance à la voie sous Dispositif.

## Balayages : en ajouter un

scans-new = Nouveau balayage
scans-new-from = Source
scans-new-strips = Deux bandes
scans-new-video = Deux colonnes ou rangées d’une vidéo
scans-new-name-hint = Vide : le nom du fichier.
scans-new-read = Importer et détecter les véhicules
scans-new-no-strip = aucune bande envoyée
scans-new-choose-strip = choisissez une bande
scans-new-strip = { $file } ({ $size })
scans-new-choose-both = Choisir les deux bandes
scans-new-drop = Déposez les deux bandes ici, ou cliquez pour choisir
scans-new-drop-hint = PNG, TIFF ou BigTIFF, niveaux de gris sur 8 ou 16 bits, de longueur quelconque.
scans-new-camera-1 = Caméra 1, qu’un véhicule atteint d’abord
scans-new-camera-2 = Caméra 2
scans-new-same-strip = Les deux caméras ne peuvent pas avoir la même bande.
scans-new-time-axis = Axe du temps
scans-new-time-width = largeur de l’image (cas usuel)
scans-new-time-height = hauteur de l’image
scans-new-no-recording = aucun enregistrement prêt
scans-new-choose-recording = choisissez un enregistrement
scans-new-recording-hint = La cadence d’images devient la cadence de lignes : utilisez une cadence constante et élevée.
scans-new-cut-along = Sens de circulation dans la vidéo
scans-new-cut-along-columns = Vers la gauche ou la droite : colonnes
scans-new-cut-along-rows_left_up = Vers le haut ou le bas, toits à gauche : rangées
scans-new-cut-along-rows_right_up = Vers le haut ou le bas, toits à droite : rangées
scans-new-cut-1 = { $along ->
    [columns] Colonne
   *[rows] Rangée
} de la caméra 1
scans-new-cut-1-hint = Celle qu’un véhicule atteint d’abord.
scans-new-cut-1-hint-to = Celle qu’un véhicule atteint d’abord, 0 à { $last_px }.
scans-new-cut-2 = { $along ->
    [columns] Colonne
   *[rows] Rangée
} de la caméra 2

## Balayages : le dispositif

scans-rig-title = Le dispositif
scans-rig-store = Enregistrer
scans-rig-traffic = Dispositif d’après le trafic
scans-rig-traffic-title = D’après le trafic
scans-rig-note = Les résultats existants gardent les anciennes valeurs et sont marqués périmés jusqu’à une nouvelle mesure.
scans-rig-undo = dispositif
scans-rig-stored = Le dispositif est enregistré.
scans-rig-stored-older = Le dispositif est enregistré. Relancez la détection des véhicules pour mettre à jour les résultats.
scans-rig-baseline = Base
scans-rig-baseline-hint = Entre les deux plans de balayage, au droit des véhicules.
scans-rig-u = Incertitude-type
scans-rig-baseline-u-hint = Limite l’exactitude de chaque vitesse.
scans-rig-rate = Cadence de lignes
scans-rig-clock = u relative de la cadence de lignes
scans-rig-clock-hint = Quartz courant : 50 ppm.
scans-rig-more = Plus : désalignement, divergence, distance à la voie, zone d’ombre
scans-rig-misalignment = Désalignement
scans-rig-from-traffic = d’après le trafic
scans-rig-misalignment-hint = Rangée d’un point dans la bande 2 moins sa rangée dans la bande 1. Vide : estimé d’après le trafic, véhicule par véhicule.
scans-rig-divergence = Angle de divergence des plans de balayage
scans-rig-divergence-hint = Positif : ils s’ouvrent vers les véhicules. La base est alors celle aux caméras.
scans-rig-divergence-u-hint = Plans réglés parallèles : l’incertitude du réglage.
scans-rig-distance = Distance à la voie (côté proche des véhicules)
scans-rig-distance-hint = Nécessaire pour la divergence seulement.
scans-lanes = Voies à plusieurs distances
scans-lanes-why = Chaque véhicule est mesuré avec la base à sa propre voie. Une voie se reconnaît à son sens et à la rangée où les pneus touchent la chaussée (caméra 1, rangée 0 en haut) ; vous pouvez aussi la choisir pour le véhicule. Sans voies, tous les véhicules sont à la distance ci-dessus.
scans-lane-of = Voie { $number }
scans-lane-name = Nom de la voie
scans-lane-way = { $way ->
    [camera_1_first] caméra 1 d’abord
    [camera_2_first] caméra 2 d’abord
   *[either] les deux
}
scans-lane-distance = Distance de ses véhicules (côté proche)
scans-lane-from = Pneus à partir de la rangée
scans-lane-to = Pneus jusqu’à la rangée
scans-lane-rows-hint = Laissez les deux vides si le sens suffit à reconnaître la voie.
scans-lane-shadow-rig = celle du dispositif
scans-lane-add = Ajouter une voie
scans-lane-remove = Retirer cette voie
scans-lane-problem-name = Saisissez un nom de 40 caractères au plus.
scans-lane-problem-twice = Une autre voie porte ce nom ; saisissez-en un autre.
scans-lane-problem-distance = Saisissez une longueur supérieure à 0.
scans-lane-problem-rows = Saisissez les deux rangées, d’abord la plus haute (le plus petit numéro), ou laissez les deux vides.
scans-rig-shadow = Zone d’ombre
scans-rig-shadow-hint = Partie basse de l’image, où il n’y a que chaussée et ombres : aucun véhicule n’y est cherché. Une caméra haute près de la voie en demande plus.
scans-rig-problem-shadow = Saisissez une part de 0 à 60 %.
scans-rig-problem-number = Saisissez un nombre positif ou nul, ou laissez vide.
scans-rig-problem-length = Saisissez une longueur, ou laissez vide.
scans-rig-problem-angle = Saisissez un angle d’au plus 200 mrad, ou laissez vide.
scans-rig-problem-baseline = Saisissez la distance entre les deux plans de balayage.
scans-rig-problem-rate = Saisissez la cadence de lignes des caméras.
scans-rig-problem-misalignment = Saisissez un nombre de pixels, ou laissez vide.
scans-rig-problem-distance = Saisissez la distance à la voie, ou laissez la divergence vide.
scans-rig-problem-misalignment-u = Saisissez aussi le désalignement, ou laissez son incertitude vide.
scans-rig-distance-u-hint = Dispersion latérale des véhicules ; compte si les plans divergent.
scans-rig-correlation = Corrélation de la base et de la divergence
scans-rig-correlation-hint = Issue d’un étalonnage ; effacée dès que vous saisissez une autre base ou divergence.
scans-rig-problem-correlation = Saisissez un nombre de −1 à 1, ou laissez vide.
scans-calibrate = Étalonner le dispositif…
scans-calibrate-why = Base et divergence d’après un jalon ou un panneau qui passe devant les deux caméras à deux distances.
scans-calibrate-title = Étalonner le dispositif
scans-calibrate-how = Faites passer un jalon ou un panneau devant les deux caméras à deux distances ou plus, plusieurs fois à chacune : par exemple la voie proche et la voie éloignée. Tenez ses repères à la hauteur du milieu d’un véhicule.
scans-calibrate-way = Méthode
scans-calibrate-way-board = Panneau de largeur connue
scans-calibrate-way-positions = Jalon le long d’un mètre ruban
scans-calibrate-way-speed = Jalon à vitesse connue
scans-calibrate-hint-board = Passez un panneau vertical d’un mouvement régulier, dans le sens du trafic. Indiquez les lignes de son premier et de son dernier bord dans les deux bandes : sa largeur donne sa vitesse.
scans-calibrate-hint-positions = Déplacez un jalon vertical le long d’un mètre ruban posé dans le sens du trafic. Indiquez où chaque caméra le voit.
scans-calibrate-hint-speed = Indiquez la vitesse du jalon et sa ligne dans chaque bande ; il faut la cadence de lignes des caméras.
scans-calibrate-tape = Incertitude de l’échelle du mètre ruban
scans-calibrate-tape-hint = Incertitude-type commune à toutes les longueurs mesurées au mètre ruban. Vide : aucune.
scans-calibrate-tape-problem = Saisissez une part de 0 à 10 %.
scans-calibrate-distance-problem = Saisissez la distance aux véhicules : les vitesses utilisent la base à cette distance.
scans-calibrate-compute = Calculer
scans-calibrate-busy = étalonnage
scans-calibrate-store = Appliquer
scans-calibrate-answer = Résultat des passages
scans-calibrate-lane = Base à la voie, { $distance }
scans-calibrate-share = ({ $percent } % de chaque vitesse)
scans-calibrate-baseline = Base aux caméras
scans-calibrate-agree = Cohérence des passages
scans-calibrate-chi2 = khi-deux { $chi2 }, { $degrees ->
    [one] { NUMBER($degrees) } degré
   *[other] { NUMBER($degrees) } degrés
 } de liberté : p = { $percent } %
scans-calibrate-mrad = { $value } ± { $U95 } mrad
scans-calibrate-passes = Passages et résidus
scans-calibrate-span = Base à cette distance
scans-calibrate-residual = Résidu
scans-calibrate-history = Étalonnages
scans-calibrate-one = { $number }, par { $who }, { $passes } passages
scans-calibrate-in-force = en vigueur
scans-calibrate-use-one = Utiliser l’étalonnage { $number }
scans-passes = Passages
scans-passes-typed = passages saisis
scans-passes-number = Passage
scans-passes-cell = Passage { $number }, { $column }
scans-passes-add = Ajouter un passage
scans-passes-choose = CSV de passages
scans-passes-drop = Ou déposez un CSV de passages
scans-passes-drop-hint = Un passage par ligne ; les colonnes sont celles de « sightline rig calibrate ».
scans-passes-refused = La ligne { $row } est ignorée.
scans-passes-distance-shown = Distance
scans-passes-head-distance_m = Distance, m
scans-passes-u = u
scans-passes-head-width_m = Largeur, m
scans-passes-head-position_1_m = À la caméra 1, m
scans-passes-head-position_2_m = À la caméra 2, m
scans-passes-head-speed_mps = Vitesse, m/s
scans-passes-head-line_1 = Ligne, bande 1
scans-passes-head-line_2 = Ligne, bande 2
scans-passes-head-front_line_1 = Premier bord, bande 1
scans-passes-head-rear_line_1 = Dernier bord, bande 1
scans-passes-head-front_line_2 = Premier bord, bande 2
scans-passes-head-rear_line_2 = Dernier bord, bande 2
scans-passes-head-u_line = u d’une ligne

## Balayages : le dispositif tel que le trafic l’indique

scans-traffic-loading = estimations d’après le trafic
scans-traffic-swapped = Les caméras ont été échangées ; les véhicules sont à nouveau recherchés.
scans-traffic-swap = Échanger les caméras
scans-traffic-table = Estimations d’après le trafic
scans-traffic-says = Paramètre
scans-traffic-value = Estimation (u)
scans-traffic-from = Véhicules
scans-traffic-in-force = En vigueur
scans-traffic-take = Utiliser
scans-traffic-gain = Lumière, rapport caméra 2 / caméra 1
scans-traffic-gain-own = par véhicule
scans-traffic-baseline = { $of ->
    [length] Base d’après les longueurs
   *[wheelbase] Base d’après les empattements
}
scans-traffic-note = u est l’incertitude-type. Les estimations ne s’appliquent pas d’elles-mêmes. Choisissez Utiliser, puis enregistrez.
scans-traffic-use = Utiliser…
scans-traffic-use-for = Utiliser pour : { $what }

## Balayage : le plan de travail

scan-loading = balayage
scan-vehicles = Véhicules
scan-head-vehicle = Véhicule
scan-calibrate = Étalonner la hauteur
scan-rig = Dispositif…
scan-find = Détecter les véhicules…
scan-nothing-found-title = Aucun véhicule trouvé
scan-nothing-yet-title = Pas encore de véhicules
scan-nothing-found = Vérifiez les bandes. Ajoutez un véhicule manqué en deux clics : son avant et son arrière.
scan-nothing-yet = Détectez les véhicules pour mesurer automatiquement avant, arrière, vitesse, longueur et intervalles.
scan-find-now = Détecter les véhicules
scan-none-choose = En choisir un
scan-on = Avancer le long des bandes
scan-back = Reculer le long des bandes
scan-on-window = Avancer d’une fenêtre
scan-back-window = Reculer d’une fenêtre
scan-to-first = À la première ligne
scan-to-last = À la dernière ligne
scan-next-vehicle = Véhicule suivant
scan-previous-vehicle = Véhicule précédent
scan-take-out-vehicle = Retirer le véhicule
scan-last-vehicle = C’est le dernier véhicule.
scan-first-vehicle = C’est le premier véhicule.
scan-search-stopped = La détection s’est arrêtée.

## Balayage : détecter les véhicules

scan-find-title = Détecter les véhicules
scan-find-and-measure = Détecter et mesurer
scan-find-again = Mesurer à nouveau
scan-find-method = Méthode
scan-find-direct = Recalage direct
scan-find-paper = Appariement de blocs (Douxchamps et al.)
scan-find-direct-what = Recale les deux bandes d’un véhicule dans leur ensemble : vitesse, accélération et désalignement des caméras en un seul ajustement. Par défaut.
scan-find-paper-what = Appariement de blocs et régression linéaire, tels que publiés par Douxchamps, Macq et Chihara ; pour comparaison.
scan-find-what = Étendue
scan-find-all = Chercher dans tout l’enregistrement
scan-find-known = Mesurer à nouveau les véhicules connus
scan-find-note = Les bornes placées à la main et les véhicules retirés sont gardés. Les résultats validés qui changent retournent en vérification.

## Balayage : les bandes, et ce que doit viser le prochain clic

scan-strips = bandes du balayage
scan-strips-label = Caméra 1 en haut, caméra 2 en bas, temps vers la droite
scan-camera-1 = caméra 1
scan-camera-2 = caméra 2
scan-strips-missing = Une partie de l’image n’a pas pu être chargée.
scan-asked = { $what } (Échap arrête)
scan-asked-stretch = { $what } (R étire, Échap arrête)
scan-click-camera-1 = Cliquez sur la caméra 1, la bande du haut.
scan-click-rod-distance = Indiquez à droite la distance du jalon
scan-click-rod = Cliquez sur le jalon à { $distance }, à { $height } au-dessus de la chaussée
scan-click-tyre = Cliquez là où un pneu touche la chaussée, sur la caméra 1
scan-click-target = { $target ->
    [roof] Cliquez sur { target-hint-roof }
    [driver_eye] Cliquez sur { target-hint-driver_eye }
    [taillight] Cliquez sur { target-hint-taillight }
    [headlight] Cliquez sur { target-hint-headlight }
   *[other] Cliquez sur { target-hint-other }
}
scan-click-any-target = Cliquez sur la cible
scan-click-front-wheel = Cliquez sur le moyeu de la roue avant, sur la caméra 1
scan-click-rear-wheel = Cliquez sur le moyeu de la roue arrière, sur la caméra 1
scan-click-front = Cliquez sur l’avant du véhicule, sur la caméra 1
scan-click-rear = Cliquez sur l’arrière du véhicule, sur la caméra 1
scan-drawn-height = { $target } { $height }
scan-drawn-away = à { $distance }
scan-drawn-mark-away = { $height }, à { $distance }

## Balayage : le tableau des véhicules

scan-head-number = N°
scan-head-time = Temps
scan-head-clock = Heure
scan-time-title = { $time } ; { $since } après la première ligne
scan-head-speed = Vitesse
scan-head-acceleration = Acc.
scan-head-length = Longueur
scan-head-gap = Intervalle
scan-head-distance-gap = Distance
scan-head-headway = TIV
scan-head-state = État
scan-choose-vehicle = { $vehicle } <hidden>choisir</hidden>

## Balayage : le véhicule choisi

scan-vehicle = Véhicule
scan-vehicle-none = Choisissez un véhicule dans la liste ou sur les bandes{ $key }. Son mouvement, l’ajustement et les intervalles s’affichent ici.
scan-vehicle-body = Mouvement et historique
scan-fit-loading = ajustement
scan-motion = Mouvement
scan-not-measurable = Non mesurable
scan-older = Périmé : les valeurs du dispositif ont changé. Mesurez à nouveau.
scan-length = Longueur
scan-acceleration = Accélération
scan-wheelbase = Empattement
scan-wheelbase-none = non pointé
scan-axles = Essieux
scan-axles-of = { $count ->
    [0] { $by ->
        [person] aucun, corrigé à la main
       *[machine] aucune roue trouvée
    }
    [one] { NUMBER($count) }, { $by ->
        [person] corrigé à la main
       *[machine] trouvé par Sightline
    }
   *[other] { NUMBER($count) }, { $by ->
        [person] corrigés à la main
       *[machine] trouvés par Sightline
    }
}
scan-axles-correct = Corriger les essieux
scan-axles-title = Cliquez sur un moyeu pour ajouter un essieu, sur un trait pour le retirer
scan-axles-again = Rechercher les essieux
scan-click-axle = Cliquez sur le moyeu d’une roue pour ajouter son essieu, ou sur le trait d’un essieu pour le retirer ; Échap termine.
scan-step-lane = voie du véhicule { $vehicle }
scan-step-axles = essieux du véhicule { $vehicle }
scan-passed = Passage
scan-passed-at = { $day }, { $time }
scan-passed-within = { $time } ± { $U95_s } s
scan-passed-unknown = Heure inconnue : le début de l’enregistrement n’est pas confirmé
scan-lane = Voie
scan-lane-unknown = voie inconnue
scan-lane-of = { $lane }, { $by ->
    [person] choisie à la main
   *[machine] trouvée par Sightline
}
scan-lane-tyres = (pneus à la rangée { $row })
scan-lane-choose = Choisir la voie
scan-lane-by-program = telle que trouvée par Sightline
scan-direction = Sens
scan-direction-of = { $direction ->
    [camera_2_first] caméra 2 d’abord
   *[camera_1_first] caméra 1 d’abord
}
scan-time-gap = Intervalle temporel (arrière à avant)
scan-time-gap-first = le premier véhicule
scan-distance-gap = Distance intervéhiculaire (arrière à avant)
scan-distance-gap-paper = { $gap } <muted>(par la vitesse moyenne { $paper_gap })</muted>
scan-headway = Temps intervéhiculaire (avant à avant)
scan-by = Par
scan-cause = { $method ->
    [paper] appariement de blocs
   *[direct] recalage direct
}
scan-cause-by-hand = { $method ->
    [paper] appariement de blocs, bornes placées à la main
   *[direct] recalage direct, bornes placées à la main
}
scan-cause-scatter = { $cause } ; écart-type des blocs { $percent } %
scan-misalignment = Désalignement
scan-misalignment-u = { $value_px } px (u = { $u_px } px)
scan-show = Afficher
scan-show-title = Remplir la fenêtre
scan-wheels = Pointer les roues
scan-wheels-again = Repointer les roues
scan-wheels-title = Cliquer sur les deux moyeux
scan-heights-measure = Mesurer les hauteurs
scan-heights-title = Cliquer sur le contact d’un pneu, puis toit, œil et feu
scan-evidence = Dossier de preuve
scan-evidence-title = Dossier de preuve du véhicule { $vehicle }
scan-evidence-what = Une page avec les deux images, instants, dispositif, mouvement, bilan d’incertitude, décision et signature. Elle s’ouvre sans serveur, permet à chacun de poser ses propres bornes, et se vérifie elle-même.
scan-evidence-make = Créer le dossier
scan-evidence-limit-of = Limite portant sur
scan-evidence-none = Sans limite
scan-evidence-speed = Vitesse
scan-evidence-time_gap = Intervalle temporel
scan-evidence-distance_gap = Distance intervéhiculaire
scan-evidence-most = Limite : au plus
scan-evidence-least = Limite : au moins
scan-evidence-risk = Risque de décision erronée
scan-evidence-risk-hint = Un risque plus faible élargit la bande de garde, dans laquelle rien n’est décidé. Seules les mesures validées font l’objet d’une décision.
scan-evidence-source = Source de la limite
scan-evidence-source-hint = Telle qu’elle doit figurer dans le dossier : le panneau, l’arrêté, la règle.
scan-evidence-problem = Saisissez une limite et un risque supérieurs à 0.
scan-take-out = Retirer
scan-take-out-title = Retirer le véhicule

## Balayage : ce que l’on sait d’un véhicule, son bilan et son historique

scan-known = Valeurs de référence du véhicule
scan-known-make = Marque
scan-known-model = Modèle
scan-known-length = Longueur de référence
scan-known-wheelbase = Empattement de référence
scan-known-problem = Saisissez une longueur.
scan-shadow-zone = zone d’ombre : non examinée
scan-known-off = mesuré : { $difference }
scan-references = Mesures de référence
scan-references-none = Aucune pour l’instant. Saisissez une valeur d’un radar, d’un GPS ou du compteur du véhicule.
scan-reference-speed = Vitesse
scan-reference-length = Longueur
scan-reference-wheelbase = Empattement
scan-reference-source-counter = compteur du véhicule
scan-reference-source-radar = radar
scan-reference-source-laser = cinémomètre laser
scan-reference-source-gps = GPS
scan-reference-source-loop = boucle
scan-reference-source-tape = mètre ruban
scan-reference-source-other = autre
scan-reference-says = { $quantity }, { $source } : { $value }
scan-reference-nothing = Aucune valeur mesurée à comparer.
scan-reference-within = Écart { $difference }, dans les ± { $U95 }.
scan-reference-outside = Écart { $difference }, hors des ± { $U95 }.
scan-reference-add = Ajouter une référence
scan-reference-import = Importer un CSV
scan-reference-edit = Modifier
scan-reference-edit-one = Modifier { $quantity }, { $source }
scan-reference-remove-one = Supprimer { $quantity }, { $source }
scan-reference-add-title = Référence du véhicule { $vehicle }
scan-reference-edit-title = Corriger une référence du véhicule { $vehicle }
scan-reference-store = Enregistrer
scan-reference-quantity = Grandeur
scan-reference-source = Mesuré par
scan-reference-value = Valeur
scan-reference-u = Incertitude-type (k = 1)
scan-reference-device = Instrument (facultatif)
scan-reference-value-problem = Saisissez un nombre supérieur à 0.
scan-reference-u-problem = Saisissez une incertitude supérieure à 0.
scan-reference-note-speed = Comparée à la vitesse à laquelle l’avant atteint la caméra 1. Une référence prise ailleurs demande une incertitude plus grande.
scan-reference-note-length = Comparée à la longueur ou à l’empattement mesuré ici, les deux incertitudes étant composées.
scan-run-of = Passage du véhicule
scan-run-of-hint = Le même nom sur plusieurs véhicules les désigne comme passages d’un même véhicule.
scan-run-of-problem = Saisissez 100 caractères au plus.
scan-references-title = Importer des mesures de référence
scan-references-choose = Choisir un CSV
scan-references-drop = Déposez un CSV ici
scan-references-hint = Colonnes : number (ou time : 14:05:32.4), source, speed_kmh, u_speed_kmh ; ou encore length_m, u_length_m, wheelbase_m, device, run_of
scan-references-looking = fichier
scan-references-store = { $count ->
    [one] Importer { NUMBER($count) } ligne
   *[other] Importer { NUMBER($count) } lignes
}
scan-references-done = Importé : { $values } { $values ->
    [one] valeur
   *[other] valeurs
} de référence et { $cars } { $cars ->
    [one] nom
   *[other] noms
} de véhicule.
scan-references-lines = Lignes du fichier
scan-references-line = Ligne
scan-references-vehicle = Véhicule
scan-references-given = Indiqué
scan-references-what = Action
scan-references-why = Motif
scan-references-new = nouvelle
scan-references-replaces = remplace
scan-references-same = déjà présente
scan-references-ambiguous = ambiguë
scan-references-refused = refusée
scan-references-time = Heure indiquée
scan-references-apart = Écart
scan-references-by-time = { $number } (par l’heure)
scan-references-tolerance = Tolérance des heures
scan-references-tolerance-hint = Une ligne sans numéro est attribuée au seul véhicule passé à moins de cette durée.
scan-references-tolerance-problem = Saisissez un nombre de secondes supérieur à 0, jusqu’à 60.
scan-references-one = { $quantity } { $value }, u = { $u }
scan-budget-note = incertitudes-types
scan-budget = Bilan d’incertitude
scan-budget-source = Source
scan-budget-speed = Vitesse
scan-budget-acceleration = Accélération
scan-budget-length = Longueur
scan-history = Historique ({ NUMBER($count) })
scan-revision = <strong>{ $speed }</strong>, { $length } <muted>{ $cause }</muted>
scan-revision-who = { $person }, { $time }
scan-revision-verdict = { $verdict ->
    [accepted] { $person }, { $time } ; validé par { $reviewer }
    [rejected] { $person }, { $time } ; rejeté par { $reviewer }
   *[reopened] { $person }, { $time } ; rouvert par { $reviewer }
}
scan-revision-verdict-why = { $verdict ->
    [accepted] { $person }, { $time } ; validé par { $reviewer } : { $reason }
    [rejected] { $person }, { $time } ; rejeté par { $reviewer } : { $reason }
   *[reopened] { $person }, { $time } ; rouvert par { $reviewer } : { $reason }
}
scan-by-search = Sightline
scan-by-somebody = un autre utilisateur

## Balayage : l’ajustement d’un véhicule

scan-profile-title = Vitesse le long du véhicule
scan-profile-says = { $count ->
    [one] Vitesse de { NUMBER($count) } bloc le long du véhicule { $vehicle } et mouvement ajusté
   *[other] Vitesse de { NUMBER($count) } blocs le long du véhicule { $vehicle } et mouvement ajusté
}
scan-profile-none = Pas de profil de vitesse : le véhicule n’a pas de mouvement mesuré.
scan-profile-fitted = Mouvement ajusté
scan-profile-used = Bloc, utilisé
scan-profile-left-out = Bloc, exclu
scan-profile-note = Vitesse moyenne de chaque bloc entre les caméras.
scan-profile-beyond = { $count ->
    [one] { NUMBER($count) } bloc est hors de cette figure ; le CSV les contient tous.
   *[other] { NUMBER($count) } blocs sont hors de cette figure ; le CSV les contient tous.
}
scan-profile-x = Temps depuis l’avant à la caméra 1 (s)
scan-match-title = Recalage : bande 2 sur bande 1
scan-match-picture = Image du recalage
scan-match-first = 1
scan-match-second = 2
scan-match-blink = alterner
scan-match-difference = différence
scan-match-alt-first = Le véhicule sur la caméra 1
scan-match-alt-second = Le véhicule sur la caméra 2
scan-match-alt-difference = Différence des deux bandes ; gris uniforme là où elles concordent
scan-match-note = La bande 2 est déplacée selon la vitesse et l’accélération ajustées. Gris uniforme : identique. Les roues en rotation et le fond vu à travers les vitres ne concordent pas.

## Balayage : la décision

scan-reason-boundary = Une borne n’est pas à l’avant ou à l’arrière du véhicule.
scan-reason-not-one = Ce n’est pas un véhicule unique.
scan-reason-match = Les bandes ne concordent pas.
scan-verdict-mine = Vous avez placé ces bornes : une autre personne les vérifie.
scan-verdict-given = { $verdict ->
    [accepted] Validé par { $person }
   *[rejected] Rejeté par { $person }
}
scan-verdict-given-why = { $verdict ->
    [accepted] Validé par { $person } : { $reason }
   *[rejected] Rejeté par { $person } : { $reason }
}
scan-verdict-done = Véhicule { $vehicle } : { $verdict ->
    [accepted] validé.
   *[rejected] rejeté.
}
scan-verdict-none-left = Aucun autre véhicule de ce balayage n’attend votre décision.
scan-verdict-reopen = Rouvrir

## Balayage : les hauteurs

scan-heights = Hauteurs
scan-heights-camera = caméra à { $height }
scan-heights-older = { $count ->
    [one] { NUMBER($count) } hauteur de ce balayage est périmée : l’étalonnage ou un retrait a changé.
   *[other] { NUMBER($count) } hauteurs de ce balayage sont périmées : l’étalonnage ou un retrait a changé.
}
scan-heights-no-pose = Les hauteurs exigent la pose de la caméra 1. Filmez un jalon à repères, ou un damier, tenu vertical à deux distances dans son plan ; pointez ensuite les repères.
scan-heights-calibrate = Étalonner la hauteur
scan-heights-calibrate-first = Les hauteurs exigent la pose de la caméra linéaire ; étalonnez d’abord la hauteur avec un jalon.
scan-height-hide = { $target ->
    [roof] Masquer les détails du toit
    [driver_eye] Masquer les détails de l’œil du conducteur
    [taillight] Masquer les détails du feu arrière
    [headlight] Masquer les détails du projecteur
   *[other] Masquer les détails de l’autre cible
}
scan-height-show = { $target ->
    [roof] Afficher les détails du toit
    [driver_eye] Afficher les détails de l’œil du conducteur
    [taillight] Afficher les détails du feu arrière
    [headlight] Afficher les détails du projecteur
   *[other] Afficher les détails de l’autre cible
}
scan-height-measure = { $target ->
    [roof] Mesurer : toit
    [driver_eye] Mesurer : œil du conducteur
    [taillight] Mesurer : feu arrière
    [headlight] Mesurer : projecteur
   *[other] Mesurer : autre cible
}
scan-height-measure-again = { $target ->
    [roof] Mesurer à nouveau : toit
    [driver_eye] Mesurer à nouveau : œil du conducteur
    [taillight] Mesurer à nouveau : feu arrière
    [headlight] Mesurer à nouveau : projecteur
   *[other] Mesurer à nouveau : autre
}
scan-heights-waiting = { $count ->
    [one] { NUMBER($count) } hauteur à vérifier
   *[other] { NUMBER($count) } hauteurs à vérifier
}
scan-height-unsaved = pas encore enregistrée…
scan-height-older = Périmée : l’étalonnage ou le retrait a changé. Recalculez.
scan-height-again = Recalculer
scan-height-withdraw = Retirer
scan-height-side-first = Indiquez d’abord le côté du conducteur ; la hauteur de l’œil en dépend.
scan-height-inset-driver_eye = Côté du conducteur
scan-height-inset-roof = Point du toit
scan-height-distance = Distance latérale
scan-height-inset = Retrait
scan-height-inset-value = { $inset } (u = { $u_inset }), estimation
scan-height-rows = Rangées
scan-height-rows-value = contact { $contact_px }, cible { $target_px }

## Balayage : le jalon, qui étalonne la hauteur

scan-rod-title = Étalonner la hauteur
scan-rod-label = Étalonnage de la hauteur
scan-rod-body = Repères du jalon
scan-rod-none-title = Pas encore de repères
scan-rod-none = Saisissez la distance du jalon à la caméra 1, puis pointez ses repères à partir du pied. Répétez à une autre distance.
scan-rod-next = Repère suivant
scan-rod-distance_m = Distance du jalon
scan-rod-height_m = Hauteur du repère
scan-rod-step_m = Pas de hauteur
scan-rod-next-note = Les distances sont horizontales, à partir du centre de la caméra. Un damier tenu vertical convient aussi : le pas de hauteur est alors le côté de ses cases.
scan-rod-marks = Repères
scan-rod-head-distance = Distance
scan-rod-head-height = Hauteur
scan-rod-head-row = Rangée
scan-rod-head-residual = Résidu
scan-rod-head-remove = Retirer
scan-rod-remove = Retirer le repère { $number }
scan-rod-result = Résultat des repères
scan-rod-camera-height = Hauteur de la caméra
scan-rod-residuals = Résidus
scan-rod-rms = { $rms_px } px RMS
scan-rod-store = Enregistrer l’étalonnage
scan-rod-clear = Retirer tous les repères
scan-rod-reset = Revenir aux valeurs enregistrées
scan-rod-u = Incertitudes-types
scan-rod-u-row = u de la rangée d’un repère
scan-rod-u-distance = u d’une distance
scan-rod-u-lean = u de l’inclinaison du jalon
scan-rod-at-least = Saisissez un nombre d’au moins { $least }.
scan-rod-distance-first = Saisissez d’abord la distance du jalon, puis pointez ses repères.
scan-rod-stored = Étalonnage enregistré. Choisissez un véhicule et mesurez ses hauteurs.
scan-rod-kept = L’étalonnage est gardé dans ce navigateur et sera envoyé au retour de la connexion.
scan-rod-stored-older = Étalonnage enregistré. Les hauteurs existantes gardent le précédent jusqu’au recalcul.

## Balayage : les étapes annulables, et ce qui est gardé jusqu’à l’envoi

scan-step-mark = repère du jalon
scan-step-mark-removed = repère retiré
scan-step-marks-removed = tous les repères retirés
scan-step-calibration = étalonnage de la hauteur
scan-step-boundaries = bornes du véhicule { $vehicle }
scan-step-wheels = roues du véhicule { $vehicle }
scan-step-known = valeurs de référence du véhicule { $vehicle }
scan-step-take-out = véhicule { $vehicle } retiré
scan-step-vehicle = véhicule { $vehicle }
scan-step-height = { $target ->
    [roof] toit du véhicule { $vehicle }
    [driver_eye] œil du conducteur du véhicule { $vehicle }
    [taillight] feu arrière du véhicule { $vehicle }
    [headlight] projecteur du véhicule { $vehicle }
   *[other] autre cible du véhicule { $vehicle }
}
scan-step-withdraw = { $target ->
    [roof] toit retiré, véhicule { $vehicle }
    [driver_eye] œil du conducteur retiré, véhicule { $vehicle }
    [taillight] feu arrière retiré, véhicule { $vehicle }
    [headlight] projecteur retiré, véhicule { $vehicle }
   *[other] autre cible retirée, véhicule { $vehicle }
}
scan-taken-out = Véhicule { $vehicle } retiré. Ctrl+Z annule.
scan-kept-vehicle = Le véhicule est gardé dans ce navigateur et apparaîtra dans la liste au retour de la connexion.
scan-wish-a-vehicle = un véhicule
scan-wish-verdict = décision sur le véhicule { $vehicle }
scan-wish-lines = avant à la ligne { $front }, arrière à la ligne { $rear }
scan-wish-clicked = pointé à la ligne { $line }, rangée { $row }
scan-wish-marks = { $count ->
    [one] { NUMBER($count) } repère à { $distances }
   *[other] { NUMBER($count) } repères à { $distances }
}
scan-wish-no-marks = aucun
scan-wish-there = dans la liste
scan-wish-taken-out = retiré
scan-wish-boundaries = bornes aux lignes { $lines }
scan-wish-hubs = roues aux lignes { $lines }
scan-wish-lane = voie { $lane }
scan-wish-axles = { NUMBER($count) } essieux
scan-wish-no-line = aucune
scan-wish-nothing-known = aucune

## Mouvement : ce que disent ensemble les balayages d’un relevé

motion-lead = Trafic, vitesses, intervalles, longueurs et hauteurs de tous les balayages de ce relevé, et accord avec les longueurs et empattements connus et avec les valeurs de référence.
motion-loading = statistiques
motion-which = Véhicules pris en compte
motion-which-accepted = Validés
motion-which-all = Inclure les non vérifiés
motion-none-accepted-title = Pas encore de véhicules validés
motion-none-accepted = Vérifiez-en sous Balayages, ou incluez les véhicules non vérifiés.
motion-none-title = Pas encore de véhicules mesurés
motion-none = Ajoutez un balayage et détectez ses véhicules.
motion-filter = Heure de prise de vue
motion-without-time = { $count ->
    [one] { NUMBER($count) } véhicule est exclu, car le début de son balayage n’est pas confirmé. <link>Confirmez-le dans Balayages</link>
   *[other] { NUMBER($count) } véhicules sont exclus, car les débuts de leurs balayages ne sont pas confirmés. <link>Confirmez-les dans Balayages</link>
}
motion-none-filmed = Aucun véhicule n’a été filmé à cette heure.
motion-counted = { $vehicles ->
    [one] { $vehicles } véhicule
   *[other] { $vehicles } véhicules
} dans { $scans ->
    [one] { $scans } balayage
   *[other] { $scans } balayages
}.
motion-counted-of = { $vehicles } { $all ->
    [one] véhicule sur { $all }
   *[other] véhicules sur { $all }
} dans { $scans ->
    [one] { $scans } balayage
   *[other] { $scans } balayages
} ; { $left }.
motion-left-to_review = { NUMBER($count) } à vérifier
motion-counter-braking = freinage
motion-left-rejected = { $count ->
    [one] { NUMBER($count) } rejeté
   *[other] { NUMBER($count) } rejetés
}
motion-left-not_measurable = { $count ->
    [one] { NUMBER($count) } n’est pas mesurable
   *[other] { NUMBER($count) } ne sont pas mesurables
}
motion-heights = Hauteurs des véhicules balayés
motion-heights-target = Cible
motion-heights-mean = Moyenne
motion-heights-sd = Écart-type
motion-heights-median = Médiane
motion-heights-u95 = U95 typique
motion-heights-to-review = À vérifier
motion-heights-rejected = Rejetées
motion-heights-waiting = { $count ->
    [one] { NUMBER($count) } hauteur attend une décision
   *[other] { NUMBER($count) } hauteurs attendent une décision
}
motion-by-lengths = D’après les longueurs
motion-by-wheelbases = D’après les empattements

## Mouvement : erreurs par rapport aux dimensions connues

motion-errors-title = Erreur par rapport aux longueurs et empattements du constructeur
motion-errors-note = avec intervalles à 95 %
motion-errors-scatter = Les intervalles ne reflètent que la dispersion de ces erreurs, sans l’erreur de la base, commune à tous les véhicules. Les roues sont pointées, et sur peu de véhicules les erreurs de pointé ne se compensent pas : elles peuvent décaler un biais hors de son intervalle.
motion-errors-table = Erreurs des longueurs et des empattements
motion-errors-of = Grandeur
motion-errors-n = n
motion-bias_m = Biais
motion-mae_m = MAE
motion-rmse_m = RMSE
motion-sd_m = Écart-type
motion-length-daytime = Longueur, de jour
motion-length-low_light = Longueur, faible luminosité
motion-length-overall = Longueur, ensemble
motion-wheelbase-daytime = Empattement, de jour
motion-wheelbase-low_light = Empattement, faible luminosité
motion-wheelbase-overall = Empattement, ensemble
motion-errors-none = Aucun véhicule n’a de dimension connue.
motion-references-title = Écart aux mesures de référence
motion-references-note = mesure moins référence
motion-references-of = Référence
motion-references-n = n
motion-references-mean = Moyenne
motion-references-share = Dans l’U95 composée
motion-references-by = { $quantity }, { $source }
motion-references-all = toutes sources
motion-references-within = { $within } sur { $n }
motion-references-percent = { $percent } %
motion-references-shared = Environ 95 % devraient être dans leur U95 composée. Les véhicules d’un même dispositif partagent l’erreur de sa base : plusieurs peuvent en sortir ensemble.
motion-cars-title = Passages d’un même véhicule
motion-cars-note = longueur et empattement doivent concorder d’un passage à l’autre
motion-cars-runs = { $count ->
    [one] { NUMBER($count) } passage : { $vehicles }.
   *[other] { NUMBER($count) } passages : { $vehicles }.
}
motion-cars-speed = Vitesse moyenne { $mean }, écart-type { $sd }.
motion-cars-speed-one = Vitesse { $mean }.
motion-cars-table = Passages de { $car } réunis
motion-cars-size = Dimension
motion-cars-mean = Moyenne
motion-cars-stated = u indiquée d’un passage
motion-cars-chi-square = Khi-deux
motion-cars-chi = { $chi_square } ({ $degrees } d.d.l., p = { $p })
motion-cars-says = Passages
motion-cars-agree = Compatibles avec les incertitudes indiquées.
motion-cars-too_far_apart = Diffèrent plus qu’indiqué : contrôlez les bornes, et s’il s’agit du même véhicule.
motion-cars-too_alike = Diffèrent moins qu’indiqué : la u indiquée est trop grande.
motion-cars-too_few = Un seul passage ; il en faut deux.

## Mouvement : distributions

motion-speed = Vitesse quand l’avant atteint la caméra 1
motion-length = Longueur
motion-time_gap = Intervalle temporel, arrière à avant
motion-distance_gap = Distance intervéhiculaire, arrière à avant
motion-headway = Temps intervéhiculaire, avant à avant
motion-percentile = P{ $percent } = { $value }
motion-percentile-interval = P{ $percent } = { $value } ({ $low } à { $high })
motion-spread-says = { $count ->
    [one] Fonction de répartition de { NUMBER($count) } véhicule ; { $percentiles } { $unit }
   *[other] Fonction de répartition de { NUMBER($count) } véhicules ; { $percentiles } { $unit }
}
motion-spread-note = Centiles en { $unit }, avec intervalles à 95 % : { $percentiles }.

## Mouvement : le tableau de l’article

flows-title = Trafic par tranche horaire
flows-note = Le débit, les temps intervéhiculaires et le taux d’occupation comprennent tous les véhicules trouvés ; les vitesses et longueurs, les véhicules mesurés choisis ci-dessus.
flows-lane = { $name }, { $lane }
flows-direction = { $scan } : { $direction ->
    [camera_2_first] caméra 2 d’abord
   *[camera_1_first] caméra 1 d’abord
}
flows-minutes = Durée d’une tranche
flows-minutes-of = { $minutes } min
flows-loading = trafic
flows-table = Trafic de { $scan }
flows-table-note = Sous une valeur : son incertitude-type u (k = 1), ou son intervalle à 95 %. L’intervalle d’un débit suppose des véhicules qui arrivent indépendamment les uns des autres. « Près d’un bord », « proches » : à moins de leur U95 du début ou de la fin de la tranche, ou d’une limite de la classe ; ces véhicules sont peut-être de la voisine. Classes par longueur : les quatre des compteurs des routes principales d’Angleterre.
flows-few = Les graphiques sont tracés à partir de trois tranches : avec des tranches de cette durée, il faut un balayage d’environ { NUMBER($enough) } min. Le tableau donne ce qui a été enregistré.
flows-unplaced = { $count ->
    [one] { NUMBER($count) } véhicule n’a pas été mesuré, n’a pas d’heure et n’est dans aucune tranche.
   *[other] { NUMBER($count) } véhicules n’ont pas été mesurés, n’ont pas d’heure et ne sont dans aucune tranche.
}
flows-columns = Colonnes du trafic de { $scan }
flows-columns-flow = Débit
flows-columns-speeds = Vitesses et TIV
flows-columns-lengths = Classes de longueur
flows-head-from = Début
flows-head-watched = Observé
flows-head-vehicles = Véhicules
flows-head-flow = Débit
flows-head-measured = Vitesses
flows-head-time-mean = Moy. temporelle
flows-head-space-mean = Moy. spatiale
flows-head-occupancy = Taux d’occ.
flows-head-density = Concentration
flows-head-unclassed = Sans longueur
flows-partial = partielle
flows-refused = refusés : { NUMBER($count) }
flows-near-edge = près d’un bord : { NUMBER($count) }
flows-axles = { $axles } essieux : { NUMBER($count) }
flows-axles-many = 5 ou plus
flows-near-limit = proches : { NUMBER($count) }
flows-u = u = { $u }
flows-axis-time = Heure
flows-flow = Débit
flows-flow-of = Débit, { $scan }
flows-flow-says = Débit de { NUMBER($count) } tranches ; maximum, { $flow } par heure, à partir de { $time }.
flows-flow-note = Trait épais : débit d’une tranche de { $minutes } min, sur le temps observé ; trait fin : son intervalle à 95 %.
flows-speed = Vitesse
flows-speed-of = Vitesse, { $scan }
flows-speed-says = Vitesse moyenne spatiale de { NUMBER($count) } tranches.
flows-speed-note = Trait épais : vitesse moyenne spatiale ; trait fin : du 15e au 85e centile des vitesses.
flows-speed-none = Aucune tranche n’a de vitesse validée.
flows-flow-by-density-of = Débit selon la concentration, { $scan }
flows-speed-by-flow-of = Vitesse selon le débit, { $scan }
flows-fundamental-says = Diagramme fondamental ; tranches avec une vitesse : { NUMBER($count) }.
flows-fundamental-note = Chaque point est une tranche ; point vide : tranche observée en partie seulement. La concentration est le débit divisé par la vitesse moyenne spatiale.
unit-per-hour = 1/h
unit-per-km = 1/km
motion-paper-title = Présentation du tableau I, Douxchamps et al.
motion-paper-own = Véhicules de ce relevé
motion-paper-printed = Tableau I de Douxchamps et al., tel qu’imprimé
motion-head-vehicle = Véhicule
motion-head-car = Voiture du tableau I
motion-head-speed = Vitesse
motion-head-acceleration = Acc.
motion-head-size = Longueur
motion-head-counter = Compteur
motion-head-reference = Vitesse de référence
motion-head-true = Vraie
motion-head-fit-error = Erreur d’ajust. (%)

## Statistiques : la page

results-heights = Hauteurs et normes
results-errors = Erreurs
results-conclusion = Conclusion
results-paper = Comme dans l’article
results-paper-help = Affiche, à côté des hauteurs vraies, les centiles corrigés et non corrigés, les densités et les lignes de Dupuis et al.
statistics-filter-more = Plus de filtres
review-queue-tab = File
statistics-lead = Erreurs par rapport aux hauteurs du constructeur et distributions des hauteurs mesurées.
statistics-loading = statistiques
statistics-by-size = { $count ->
    [one] 1 toit n’a pas de hauteur de référence car son modèle a été choisi d’après ses dimensions.
   *[other] { NUMBER($count) } toits n’ont pas de hauteur de référence car leurs modèles ont été choisis d’après leurs dimensions.
}
statistics-counted = { $measurements ->
    [one] { $measurements } mesure
   *[other] { $measurements } mesures
} de { $vehicles ->
    [one] { $vehicles } véhicule
   *[other] { $vehicles } véhicules
}, { $roofs ->
    [one] { $roofs } toit
   *[other] { $roofs } toits
} avec hauteur du constructeur.
statistics-without-time = { $count ->
    [one] { NUMBER($count) } véhicule est exclu, car le début de son enregistrement n’est pas confirmé. <link>Confirmez-le dans Enregistrements</link>
   *[other] { NUMBER($count) } véhicules sont exclus, car les débuts de leurs enregistrements ne sont pas confirmés. <link>Confirmez-les dans Enregistrements</link>
}
statistics-without-class = { $count ->
    [one] { NUMBER($count) } véhicule n’a pas de classe et est exclu des résultats par classe. <link>Choisissez-la dans Mesure</link> (liste : Sans classe).
   *[other] { NUMBER($count) } véhicules n’ont pas de classe et sont exclus des résultats par classe. <link>Choisissez-la dans Mesure</link> (liste : Sans classe).
}
statistics-left-out = Exclues : { $states }.
statistics-of-scans = { $count ->
    [one] 1 hauteur de balayages figure dans l’onglet Mouvement.
   *[other] { NUMBER($count) } hauteurs de balayages figurent dans l’onglet Mouvement.
}
statistics-left-out-state = { $state ->
    [to_review] à vérifier ({ NUMBER($count) })
    [reopened] rouvertes ({ NUMBER($count) })
    [rejected] rejetées ({ NUMBER($count) })
    [accepted] validées ({ NUMBER($count) })
    [out_of_sample] hors échantillon ({ NUMBER($count) })
   *[fixed] corrigées ({ NUMBER($count) })
}
statistics-none-accepted-title = Pas encore de mesures validées
statistics-none-title = Aucune mesure ici
statistics-to-review = Aller à la vérification
statistics-show-to-review = Inclure les non vérifiées
statistics-to-measure = Mesurer des véhicules
statistics-none-accepted = { $count ->
    [one] Seules les mesures validées comptent, et { NUMBER($count) } mesure attend sa vérification.
   *[other] Seules les mesures validées comptent, et { NUMBER($count) } mesures attendent leur vérification.
}
statistics-none-filtered = Aucune mesure ne correspond au filtre. Effacez-le ou modifiez-le.
statistics-none = Mesurez des véhicules et faites vérifier les mesures ; leurs chiffres apparaîtront ici.
statistics-taillight = Feu arrière, bord inférieur

## Statistiques : le filtre

statistics-filter = Filtre
statistics-filter-state = Vérification
statistics-filter-state-all = toutes
statistics-filter-target = Cible
statistics-filter-target-all = toutes
statistics-filter-lighting = Luminosité
statistics-filter-any = toutes
statistics-filter-operator = Opérateur
statistics-filter-anybody = tous
statistics-filter-filmed_from = Filmé du
statistics-filter-filmed_to = Filmé jusqu’au
statistics-filter-hour_from = De l’heure
statistics-filter-hour_to = À l’heure
statistics-filter-over-midnight = Après minuit : chaque nuit appartient au jour où elle commence.
statistics-filter-first-day = Mesuré du (UTC)
statistics-filter-last-day = Mesuré jusqu’au (UTC)
statistics-filter-correction = Correction
statistics-correction-inset = retrait (par défaut)
statistics-correction-shift = erreur moyenne (Dupuis et al.)
statistics-correction-none = aucune (retrait 0)
statistics-correction-regression = régression
statistics-correction-deconvolution = déconvolution
statistics-filter-rounding = Tableau d’erreurs
statistics-rounding-cm = cm entiers (Dupuis et al.)
statistics-rounding-none = sans arrondi
statistics-filter-surveys = Relevés
statistics-filter-surveys-some = { $count ->
    [one] { NUMBER($count) } relevé
   *[other] { NUMBER($count) } relevés
}
statistics-filter-surveys-none = tous les relevés
statistics-filter-surveys-help = Relevés pris en compte ; aucun choix : tous
statistics-reference-u = u d’une hauteur de référence
statistics-reference-u-hint = Pour les hauteurs sans u propre. Loi uniforme, demi-étendue { $limit }
statistics-reference-u-inches = Saisissez un nombre de pouces.
statistics-reference-u-millimetres = Saisissez un nombre de millimètres.

## Statistiques : le tableau d’erreurs

stat-trend-needs = Une tendance demande au moins { $least } véhicules ; { stat-there-are }.
stat-heights-alike = Toutes les hauteurs sont égales ; il n’y a pas de tendance.
stat-limits-need = Des limites de concordance demandent au moins { $least } véhicules ; { stat-there-are }.
stat-variance-shares-need = Des parts de la variance demandent au moins { $least } véhicules ; { stat-there-are }.
stat-errors-alike = Toutes les erreurs sont égales ; rien ne peut être dit de leur dispersion.
stat-errors-of-one-size = Toutes les erreurs sont de même grandeur ; il n’y a pas de tendance.
stat-errors-without-interval = toutes les erreurs sont égales ; biais, MAE, RMSE et écart-type n’ont pas d’intervalle
stat-reference-explains-all = L’incertitude des hauteurs de référence explique toute la variance des erreurs : il ne reste rien pour la mesure.
stat-reference-explains = L’incertitude des hauteurs de référence explique { $share } % de la variance des erreurs ; { SMALL($camera_sd_m, digits: 0) } restent pour la mesure.
stat-shifted = L’erreur signée moyenne de { NUMBER($count) } véhicules de hauteur connue, { SMALL($mean_m, digits: 1) }, a été retranchée de chaque hauteur (comme dans Dupuis et al.).
stat-by-inset = Chaque hauteur est corrigée du retrait de sa mesure ; aucune autre correction n’est faite.
stat-correction-needs = Cette correction demande au moins { $least } véhicules à hauteur de référence ; { stat-there-are }.
stat-known-alike = Les véhicules de hauteur connue ont tous la même hauteur : leur erreur n’a pas de tendance avec elle.
stat-variance-unknown = Les hauteurs de référence expliquent à elles seules la variance des erreurs : celle de la mesure est inconnue et ne peut être retirée.
stat-variance-needs = Une variance demande au moins 2 hauteurs.
stat-variance-too-large = La variance de la mesure dépasse celle des hauteurs ; elle ne peut être retirée.
stat-uncorrected = Hauteurs comme dans Dupuis et al. (retrait 0), sans correction.
stat-deconvolved = Après le décalage de { SMALL($mean_m, digits: 1) }, l’écart-type propre de la mesure, { SMALL($camera_sd_m, digits: 1) }, a été retiré : chaque hauteur s’est rapprochée de la moyenne de { $keep } %.
stat-percentile-needs = P{ $percent } exige { NUMBER($needed) } véhicules ; { stat-there-are }
stat-percentile-needs-alike = P{ $percent } exige { NUMBER($needed) } véhicules ; { stat-there-are }, équivalant à { NUMBER($like) } de même poids
stat-density-needs = Une densité demande au moins { $least } véhicules ; { stat-there-are }.
stat-values-alike = Toutes les valeurs sont égales ; une densité demande des valeurs différentes.
stat-no-reference = aucune hauteur retenue de ce groupe n’a de hauteur de référence
stat-none-of-class = aucune hauteur validée de sa classe
stat-vehicles-give = { NUMBER($vehicles) } véhicules donnent au centile { $percent } un intervalle à 95 % d’environ { SMALL($width_m, digits: 0) }, pour des hauteurs de loi normale et d’écart-type { SMALL($sd_m, digits: 0) }.
stat-heights-needed = demande { NUMBER($needed) } hauteurs ; { stat-there-are }
stat-sites = les écarts entre { $sites } sites
stat-shared-errors = les erreurs communes aux hauteurs
stat-random-error-removed = l’erreur aléatoire (retirée des valeurs)
stat-random-errors = les erreurs aléatoires des hauteurs
stat-known-heights = les erreurs des hauteurs connues (les deux restent dans les valeurs)
stat-known-without-u = aucune hauteur connue n’a d’incertitude à laquelle comparer
stat-known-u-is-corrected = les incertitudes indiquées sont celles de hauteurs corrigées de leur retrait
stat-true-heights-alike = les hauteurs sont toutes égales
stat-heights-closer-than-errors = les hauteurs sont plus proches les unes des autres que leurs incertitudes ne le permettent
stat-sampling = l’échantillonnage
stat-alone = { $part } seulement
stat-too-few-errors = trop peu d’erreurs différentes pour un intervalle par bootstrap
stat-no-value = Aucun véhicule n’a cette valeur.
stat-group-empty = aucun véhicule dans ce groupe
stat-regressed = La régression de l’erreur sur la hauteur mesurée de { NUMBER($count) } véhicules ({ SMALL($intercept_m, digits: 1) } à la hauteur 0 et { $slope } mm de plus par m) a été retranchée de chaque hauteur.
stat-extrapolated = { $outside } % des hauteurs sont hors des { NUMBER($low_m, minimumFractionDigits: 2) } à { NUMBER($high_m, minimumFractionDigits: 2) } m sur lesquels s’appuie la régression : la correction y extrapole et n’est pas fiable.
stat-there-are = { $count ->
    [0] il n’y en a aucun
   *[other] il y en a { NUMBER($count) }
}
stat-too-few = { $count ->
    [one] { NUMBER($count) } véhicule ne suffit pas pour un intervalle ; il en faut { $needed }
   *[other] { NUMBER($count) } véhicules ne suffisent pas pour un intervalle ; il en faut { $needed }
}
stat-too-few-of-spread = { $count ->
    [one] { NUMBER($count) } véhicule ne suffit pas pour un intervalle de MAE, RMSE et écart-type ; il en faut { $needed }
   *[other] { NUMBER($count) } véhicules ne suffisent pas pour un intervalle de MAE, RMSE et écart-type ; il en faut { $needed }
}
stat-holding-sites = { $parts } ; ils valent pour des routes comme celles de ces sites
stat-holding-unlike-sites = { $parts } ; ils valent pour des routes comme celles de ces sites, qui diffèrent de plus de la moitié de ce dont diffèrent leurs véhicules : les intervalles de centiles loin de la médiane contiennent alors la vraie valeur dans moins de 95 % des cas ; mesurez à plus de sites, ou comparez des sites d’une même sorte
stat-holding-place = { $parts } ; ils valent pour le seul site du relevé
stat-errors-of = { $heights ->
    [inset] Hauteurs corrigées du retrait de chaque mesure
   *[paper] Hauteurs comme dans Dupuis et al. (retrait 0)
} par rapport aux hauteurs du constructeur, { $rounded ->
    [cm] arrondies au centimètre comme dans Dupuis et al.
   *[none] non arrondies
} ; toutes les valeurs viennent des erreurs individuelles.
statistics-errors-title = Erreur par rapport aux hauteurs du constructeur
statistics-errors-save = Tableau d’erreurs en CSV
statistics-errors-head = Erreur = mesure − référence
statistics-error-bias_m = Biais
statistics-error-mae_m = MAE
statistics-error-rmse_m = RMSE
statistics-error-mse_m2 = MSE
statistics-error-sd_m = Écart-type
statistics-error-pearson_error_vs_height = r(erreur, hauteur)
statistics-error-pearson_abs_error_vs_height = r(|erreur|, hauteur)
statistics-errors-note = Sous chaque valeur : son intervalle de confiance à 95 %. L’écart-type est celui de l’erreur signée, n − 1. Aucune valeur n’est agrégée à partir d’autres.
statistics-errors-holds = Les intervalles comprennent { $words }. Ceux des corrélations, de l’asymétrie et des droites de régression ne comprennent que l’échantillonnage.
statistics-shares-title = Parts des erreurs en pour cent, avec intervalles à 95 %, et asymétrie
statistics-skewness = Asymétrie
statistics-within = À { $within } près
paper-day = L’écart-type (SD) est celui de l’erreur signée et diffère de la RMSE ; il y avait donc un biais de 7 à 13 mm, qui n’est pas imprimé. Le « moins de 10 % sous 2 cm » du texte est possible ici : MAE et MSE permettent 0 à 3 % si des erreurs atteignent 7 cm.
paper-low-light = Un opérateur parfait (à 1 px près, hauteurs de référence à 3 cm près) obtient MAE 0,016 m, RMSE 0,019 m : cette colonne borne la référence, non la méthode. L’écart-type imprimé de 0,059 ft devrait être 0,062 ft. « Moins de 10 % sous 2 cm » est impossible ici : MAE et MSE imposent au moins 26,5 %.
paper-overall = Ce n’est pas la réunion des 400 et 250 véhicules : leur MAE réunie vaut 0,0198 m, leur RMSE 0,0249 m. Le « MAE < 1,8 cm » du résumé n’est pas dans le tableau ; la MSE en pieds a un facteur et un exposant faux. « Moins de 10 % sous 2 cm » demande ici une erreur de plus de 10 cm.
paper-sizes = Les longueurs imprimées dépassent de 3,1 à 9,1 % les longueurs vraies (5,6 % en moyenne), ce que le texte attribue à l’ombre, alors qu’il annonce moins de 1 % ; le freinage « à 1 % près » s’écarte jusqu’à 1,5 % des autres passages de la même voiture. La vitesse n’a jamais été comparée à la vérité, seulement au compteur de la voiture.
statistics-paper-inconsistent = Incohérences du tableau 1 de Dupuis et al.
statistics-paper-note = <strong>{ $group } :</strong> { $note }
statistics-paper-printed = Dupuis et al., tel qu’imprimé
statistics-stands-for = correspond à : { $group }
statistics-no-interval = { $figures } : { $reason }
statistics-reference-part = Ceci seul crée une corrélation de { $correlation } entre l’erreur et la hauteur, indépendamment de la caméra (u de la référence = { $u_reference }).
statistics-bland-altman = Bland et Altman : limites de concordance { $lower } ({ $lower_interval }) et { $upper } { $unit } ({ $upper_interval }), n = { $n }.

## Exemples : fichiers pour essayer

samples-pictures = Pour essayer : { NUMBER($count) } photos de laboratoire dans un ZIP (décompressez-le ; la mire a { $columns } × { $rows } coins intérieurs, cases de { $square })
samples-clip = Pour essayer : la vidéo de la démonstration
samples-catalogue = Pour essayer : un catalogue de modèles inventés

## Statistiques : erreurs par rapport aux hauteurs connues, par cible

statistics-known-title = Erreurs par cible
statistics-known-help = Hauteur mesurée moins hauteur connue, pour les hauteurs validées dont la valeur est connue (celle du constructeur, ou mesurée au mètre ruban). Les hauteurs ne sont pas arrondies. Les intervalles sont totaux ; placez le pointeur sur l’un d’eux pour voir ce qu’il comprend. Un modèle choisi d’après ses dimensions ne sert pas de référence. Les cibles de contrôle ont leurs propres lignes et sont exclues des distributions.
statistics-known-target = Cible
statistics-known-check = { $target }, cibles de contrôle
statistics-known-holds = Comprend { $words }.
statistics-known-inside = Dans leur U95
statistics-known-inside-of = { $inside } sur { $n }
statistics-known-none = Pas encore de hauteurs connues. Saisissez les hauteurs des constructeurs, des feux, ou une cible de contrôle dans les fiches des véhicules.

## Statistiques : les figures de l’erreur

statistics-group-daytime = De jour
statistics-group-low_light = Faible luminosité
statistics-group-overall = Ensemble
statistics-group-unknown = Luminosité inconnue
statistics-group-n = { $group } n = { $n }
statistics-nothing = Rien à tracer.
statistics-nothing-because = Rien à tracer : { $reason }
statistics-absolute-title = Erreur absolue, répartition
statistics-absolute-says = Part des véhicules dont l’erreur absolue ne dépasse pas la valeur donnée ; { $groups }
statistics-absolute-note = Bandes de confiance simultanées à 95 % (DKW) à partir de 30 véhicules ; elles ne comprennent que l’échantillonnage. { $groups }.
statistics-absolute-x = Erreur absolue ({ $unit })
statistics-relative-title = Erreur relative, répartition
statistics-relative-says = Part des véhicules dont l’erreur ne dépasse pas tant de pour cent de leur hauteur ; { $groups }
statistics-relative-note = Erreur absolue rapportée à la hauteur de référence. { $groups }.
statistics-relative-x = Erreur relative (%)
statistics-density-title = Erreur signée, densité
statistics-density-says = Densité de l’erreur signée ; { $groups }
statistics-density-note = Noyau gaussien, largeur de bande { $bandwidths } ; bande ponctuelle à 95 % (échantillonnage seul) à partir de 30 véhicules. { $groups }.
statistics-density-note-rounded = Noyau gaussien, largeur de bande { $bandwidths }, au moins la moitié de l’arrondi ({ $rounding }) ; bande ponctuelle à 95 % (échantillonnage seul) à partir de 30 véhicules. { $groups }.
statistics-signed-error = Erreur signée ({ $unit })
statistics-density-y = Part des véhicules (% par { $unit })
statistics-trend-title = Erreur selon la hauteur du constructeur
statistics-trend-says = Erreur signée en fonction de la hauteur du constructeur, { $count ->
    [one] { NUMBER($count) } véhicule
   *[other] { NUMBER($count) } véhicules
}.
statistics-trend-nothing = Rien à tracer : aucun véhicule n’a de hauteur de référence.
statistics-trend-x = Hauteur du constructeur ({ $unit })
statistics-trend-legend = Régression, bande à 95 %
statistics-trend = Pente { $slope } { $small } par { $unit } ({ $slope_interval }), r = { $correlation }.
statistics-trend-absolute = Erreur absolue : r = { $correlation }.

## Statistiques : une cible

statistics-heights = { $count ->
    [one] { NUMBER($count) } hauteur
   *[other] { NUMBER($count) } hauteurs
}
statistics-heights-mean = { $count ->
    [one] { NUMBER($count) } hauteur, moyenne corrigée { $mean }
   *[other] { NUMBER($count) } hauteurs, moyenne corrigée { $mean }
}
statistics-heights-mean-sd = { $count ->
    [one] { NUMBER($count) } hauteur, moyenne corrigée { $mean }, écart-type { $sd }
   *[other] { NUMBER($count) } hauteurs, moyenne corrigée { $mean }, écart-type { $sd }
}
statistics-curve-raw = non corrigée
statistics-curve-corrected = corrigée
statistics-legend-raw = non corrigée (retrait = 0)
statistics-target-ecdf-title = { $target }, répartition
statistics-target-ecdf-says = Fonction de répartition des hauteurs, { $target }, non corrigées et corrigées, { $count ->
    [one] { NUMBER($count) } véhicule
   *[other] { NUMBER($count) } véhicules
}
statistics-target-ecdf-note = Bande : 95 %, simultanée (DKW), échantillonnage seul.
statistics-target-ecdf-away = { $count ->
    [one] { NUMBER($count) } norme hors échelle.
   *[other] { NUMBER($count) } normes hors échelle.
}
statistics-target-nothing = Rien à tracer : aucune hauteur de cette cible ne correspond au filtre.
statistics-height-x = Hauteur au-dessus de la chaussée ({ $unit })
statistics-target-density-title = { $target }, densité
statistics-target-density-says = Densité des hauteurs corrigées, { $target }
statistics-target-density-note = Hauteurs corrigées, noyau gaussien, bande ponctuelle à 95 % (échantillonnage seul) à partir de 30 véhicules.
statistics-share = { $standard }, { $height } : <strong>{ $share }</strong> des { $target ->
    [driver_eye] yeux de conducteur
    [taillight] feux arrière
    [headlight] projecteurs
   *[other] hauteurs
} sont en dessous <muted>({ $low } à { $high } ; hauteurs mesurées : { NUMBER($below) } sur { NUMBER($n) })</muted>
statistics-compared-title = { $second } comparé à { $first }
statistics-compared-figure = Grandeur
statistics-compared-mean = Moyenne
statistics-compared-heights = Hauteurs
statistics-compared-of = { NUMBER($first) } et { NUMBER($second) }
statistics-compared-difference = Différence
statistics-compared-verdict = Conclusion
statistics-compared-higher = plus haut (significatif)
statistics-compared-lower = plus bas (significatif)
statistics-compared-alike = pas de différence significative
statistics-compared-unknown = pas d’intervalle : { $reason }
statistics-compared-none = Aucune cible n’a deux hauteurs ou plus dans les deux relevés.
statistics-compared-note = Différences des hauteurs vraies, relevé le plus récent moins le plus ancien, avec intervalles totaux à 95 %. Une différence est dite plus haute ou plus basse si son intervalle exclut 0. Les erreurs sont supposées indépendantes entre les relevés ; s’ils en ont en commun, les intervalles sont trop larges, jamais trop étroits.
statistics-rule-title = Normes : le même centile aujourd’hui
statistics-rule-standard = Norme
statistics-rule-rule = Règle
statistics-rule-of = { $what } : P{ $percent }, { $class }
statistics-rule-whose = { $whose ->
    [cars] voitures particulières
    [trucks] camions et tracteurs routiers
   *[all] tous les véhicules, faute de classe connue
  }{ $chosen ->
    [yes] { " " }des classes choisies
   *[no] { "" }
  }
statistics-rule-read = ici : { $whose }, n = { $n }
statistics-rule-height = Norme ({ $unit })
statistics-rule-today = Aujourd’hui ({ $unit })
statistics-rule-interval = { $low } à { $high }
statistics-rule-difference = Différence
statistics-rule-verdict = Conclusion
statistics-rule-lower = plus bas (risque d’erreur { $risk })
statistics-rule-higher = plus haut (risque d’erreur { $risk })
statistics-rule-least = inférieur à { $risk }
statistics-rule-alike = indécis ; plus bas avec une probabilité de { $lower }
statistics-rule-unknown = pas de conclusion : { $reason }
statistics-rule-none = Aucune conclusion pour l’instant sur les normes : un centile n’a d’intervalle qu’avec assez de hauteurs validées. La dernière colonne dit combien de véhicules chacun exige.
statistics-rule-note = Le centile qui fonde la norme, pour les hauteurs vraies d’aujourd’hui, avec son intervalle total à 95 %. « Plus bas » ou « plus haut » est indiqué si le risque d’erreur est d’au plus 2,5 % (JCGM 106).
statistics-percentiles = Centiles, { $target }
statistics-percentiles-save = Centiles en CSV
statistics-percentile = Centile
statistics-percentiles-corrected = Corrigée ({ $unit })
statistics-percentiles-raw = Non corrigée ({ $unit })
statistics-percentiles-true = Hauteurs vraies ({ $unit })
statistics-percentiles-total = Hauteurs vraies : l’erreur de mesure aléatoire est retirée de la dispersion. Leurs intervalles à 95 % comprennent { $words }.
statistics-percentiles-note = Les autres intervalles à 95 % ne comprennent que l’échantillonnage.
statistics-percentiles-without = { $count ->
    [one] Pourquoi { NUMBER($count) } centile n’a pas d’intervalle
   *[other] Pourquoi { NUMBER($count) } centiles n’ont pas d’intervalle
}
statistics-percentiles-reason = { $percentiles } : { $reason }.

## Statistiques : hauteurs par groupe

statistics-lateral-title = Position latérale
statistics-lateral-note = Distance du contact du pneu à la caméra, mesurée en travers de la route ; une valeur par véhicule, la médiane de ses contacts. Une voie regroupe tout le trafic qui va dans un même sens à l’image.
statistics-lateral-figure = Position latérale par voie
statistics-lateral-says = Fonctions de répartition de la distance à la caméra en travers de la route, pour { NUMBER($count) } voies.
statistics-lateral-x = Distance à la caméra en travers de la route ({ $unit })
statistics-lateral-none = Aucun véhicule n’a encore de sens : il n’y a donc pas de voies. La détection des passages le renseigne, ou indiquez-le dans le panneau du véhicule.
statistics-lateral-vehicles = Véhicules
statistics-lateral-all = Tous
statistics-lane-right = Vers la droite
statistics-lane-left = Vers la gauche
statistics-groups-title = Hauteurs corrigées par groupe
statistics-groups-target = Cible
statistics-groups-by = Grouper par
statistics-grouping-category = Catégorie
statistics-grouping-class_set = Groupe
statistics-grouping-lighting = Luminosité
statistics-grouping-site = Site
statistics-grouping-operator = Opérateur
statistics-groups-head = { $grouping ->
    [category] Catégorie
    [class_set] Groupe de classes
    [lighting] Luminosité
    [site] Site
   *[operator] Opérateur
}
statistics-groups-figure = { $grouping ->
    [category] { $target } par catégorie
    [class_set] { $target } par groupe de classes
    [lighting] { $target } par luminosité
    [site] { $target } par site
   *[operator] { $target } par opérateur
}
statistics-groups-says = Fonctions de répartition des hauteurs, { $target }, par { $grouping ->
    [category] catégorie
    [class_set] groupe de classes
    [lighting] luminosité
    [site] site
   *[operator] opérateur
}, { $count ->
    [one] { NUMBER($count) } groupe
   *[other] { NUMBER($count) } groupes
}
statistics-groups-note = Les { NUMBER($count) } plus grands groupes sur { NUMBER($all) } ; le tableau en donne { NUMBER($listed) }.
statistics-groups-nothing = { $grouping ->
    [category] Rien à tracer : aucun véhicule n’a de catégorie.
    [class_set] Rien à tracer : aucun véhicule n’est dans un groupe.
    [lighting] Rien à tracer : aucun véhicule n’a de luminosité indiquée.
    [site] Rien à tracer : aucun véhicule n’a de site.
   *[operator] Rien à tracer : aucun véhicule n’a d’opérateur.
}
statistics-groups-mean = Moyenne ({ $unit })
statistics-groups-sd = Écart-type ({ $unit })

## Statistiques : normes

statistics-standards-title = Normes de conception affichées
statistics-standards-change = Modifier les normes de ce relevé
statistics-standards-one-survey = Le tableau appartient au relevé et figure dans son archive.
statistics-standards-surveys = Chaque relevé a son propre tableau ; choisissez un relevé pour le modifier.
statistics-standards-address = Votre sélection est enregistrée dans le lien.
statistics-standards-loading = normes
statistics-standard-of-eye_car = œil, voitures
statistics-standard-of-eye_truck = œil, poids lourds
statistics-standard-of-object_stopping = obstacle, arrêt
statistics-standard-of-object_passing = obstacle, dépassement
statistics-standard-of-headlight = projecteur (angles rentrants)
statistics-standard-of-vehicle = véhicule
statistics-standard-percentile = P{ $percent }
statistics-standard-rule = P{ $percent } de { $group }
statistics-standard-edition = { $source }, { $edition }
statistics-standard-cited = Valeur citée d’après { $by } ; le texte lui-même n’a pas été consulté. À vérifier avant emploi.
statistics-standard-edition-field = Édition
statistics-standard-year = Année
statistics-standard-class = Classe du centile
statistics-standard-cited-by = Citée d’après
statistics-standard-drawn-yes = oui
statistics-standard-drawn-no = non
statistics-standards-rule = Règle
statistics-standards-drawn = Tracée
statistics-standards-standard = Norme
statistics-standards-for = Pour
statistics-standards-height = Hauteur
statistics-standards-source = Source
statistics-standards-remove = Retirer
statistics-standard-draw = Tracer { $standard }, { $what }, { $height }
statistics-standard-remove = Retirer { $standard }
statistics-standard-own-problem = Saisissez une hauteur supérieure à 0 et inférieure à 10 m, par exemple { $example }.
statistics-standard-own = Valeur propre pour
statistics-standard-height = Hauteur
statistics-standard-name = Norme
statistics-standard-for = Pour
statistics-standard-source = Source
statistics-standard-new = Nouvelle norme
statistics-standard-new-remove = Retirer la nouvelle norme
statistics-standard-problem = Saisissez la hauteur de { $standard }, par exemple { $example }.
statistics-standard-new-problem = Saisissez la hauteur de la nouvelle norme, par exemple { $example }.
statistics-standards-add = Ajouter une norme
statistics-standards-save = Enregistrer pour ce relevé

## Statistiques : combien de véhicules mesurer

statistics-plan-title = Nombre de véhicules à mesurer
statistics-plan-percentile = Centile
statistics-plan-width = Largeur de son intervalle à 95 %
statistics-plan-sd = Dispersion des hauteurs (écart-type)
statistics-plan-incomplete = Saisissez trois nombres.

## Planification : la page

planning-lead-heights = Estimez l’incertitude des hauteurs sur ce site avant d’enregistrer.
planning-lead-lines = Estimez l’incertitude des vitesses de deux caméras linéaires avant d’enregistrer.
planning-nothing-stored = Rien n’est enregistré. Pour partager ce plan, copiez l’adresse de la page.
planning-what = Objet de la planification
planning-what-heights = Hauteurs (vidéo)
planning-what-lines = Vitesses (balayage linéaire)
planning-loading-cameras = caméras
planning-loading-rig = dispositif du relevé
planning-loading = plan
plan-board-square = Placez la mire perpendiculaire à la chaussée, et non à la verticale : avec un dévers de { $crossfall } %, une mire verticale fausse les hauteurs de { SMALL($here_m, digits: 0) } à { $distance_m } m et de { SMALL($further_m, digits: 0) } 1 m plus loin.
plan-out-of-sight = La route ou la cible est hors de l’image pour : { $targets } ; reculez ou prenez un objectif de plus courte focale.
plan-oblique = Une mire vue en biais détermine mieux l’orientation de la caméra qu’une mire vue de face, mais les pointés sont un peu moins précis : caméra tournée de 30 degrés le long de la route, la hauteur d’un œil est à ± { SMALL($U95_turned_m, digits: 0) } au lieu de ± { SMALL($U95_square_m, digits: 0) }.
plan-second-frame = Pointez l’œil et le contact sur une deuxième image quand la vitesse le permet : avec { $travel_m } m parcourus, le retrait est calculé au lieu d’être supposé, et ± { SMALL($U95_one_m, digits: 0) } deviennent ± { SMALL($U95_two_m, digits: 0) }. À 50 km/h et 25 images/s, cela fait { $frames } images plus loin.
plan-board-at-wheel-path = Placez la mire à la trace de roues, à { $distance_m } m, et non à { $board_m } m : les erreurs de pose, d’inclinaison et de focale s’annulent à la distance de la mire et croissent en s’en éloignant.
plan-lane-close = La voie est très proche ; reculez à 2 m au moins.
plan-board-unseen = L’image ne montrerait pas une mire à { $board_m } m dont la rangée du haut est à { $board_top_m } m au-dessus de la route ; placez-la à la trace de roues, reculez ou prenez un objectif de plus courte focale.
plan-camera-at-eye = La caméra est à peu près à la hauteur de l’œil du conducteur ({ $height_m } m), où le retrait ne compte guère ; pour les toits ou les feux, placez-la à leur hauteur.
plan-second-frame-no-gain = Une deuxième image { $travel_m } m plus loin ne réduit pas l’incertitude ici (± { SMALL($U95_two_m, digits: 0) } pour un œil) ; prenez des images plus éloignées.
plan-camera-height = Placez la caméra à la hauteur à mesurer, où le retrait ne compte pas : { $height_m } m pour l’œil du conducteur. À { $camera_height_m } m, ignorer le retrait fausse la hauteur de { SMALL($near_m, digits: 0) } pour un conducteur côté proche et { SMALL($far_m, digits: 0) } côté éloigné.
plan-target = { $target ->
    [driver_eye] œil du conducteur
    [driver_eye_far] œil du conducteur du côté éloigné
    [taillight] feu arrière
    [headlight] projecteur
    [roof] toit
   *[other] autre
}
plan-lines-expected = Valeurs attendues de la méthode par défaut, d’après des véhicules simulés qui remplissent l’image ; peu de texture, un bruit fort ou la pluie les dégradent, et l’incertitude propre à chaque véhicule indique ce qui est atteint.
plan-lines-few = Seules { $lines } lignes séparent les caméras ; prenez une cadence plus élevée ou une base plus longue, sinon ce véhicule est à peine mesurable.
plan-lines-coarse = Le véhicule avance de { SMALL($line_m, digits: 1) } d’une ligne à la suivante ; au-delà de { SMALL($coarse_m, digits: 0) } la plupart des véhicules sont refusés. Prenez { $rate_hz } Hz ou plus.
plan-lines-apart = Le véhicule avance de { SMALL($line_m, digits: 1) } d’une ligne à la suivante, ce qui se mesure ; { $rate_hz } Hz ramènent ce pas à { SMALL($good_m, digits: 0) }.
plan-lines-U95 = L’U95 de la vitesse est de { $reached } %, plus que les { $allowed } % admis ; prenez une base { $times } fois plus longue, mesurée avec la même exactitude.
plan-lines-baseline-exact = La base est tenue pour exacte ; saisissez son incertitude, car elle entre dans toute vitesse.
plan-lines-baseline-limits = C’est la base qui limite, non la cadence de lignes : son incertitude-type est de { $baseline } %, le recalage des bandes ajoute { $strips } %. Mesurez d’abord la base plus exactement.
plan-lines-strips-limit = C’est le recalage des bandes qui limite, non la base : il ajoute { $strips } % (incertitude-type), la base { $baseline } %. Prenez une base plus longue.
plan-lines-no-share = L’erreur doit être une part entre 0 et 1 ; vitesse et base doivent être supérieures à 0.
plan-lines-above-zero = Vitesse, base et cadence de lignes doivent être supérieures à 0.
plan-lines-vehicle = Le véhicule a au plus 100 m de long, l’intervalle au plus 3600 s ; tous deux supérieurs à 0.
plan-lines-u-baseline = L’incertitude de la base doit être d’au moins 0 et inférieure à la base.
planning-advice = Conseils
planning-lens-exact = Incertitude d’étalonnage supposée nulle.
planning-lens-exact-plain = Objectif supposé idéal : sans distorsion ni incertitude d’étalonnage.
planning-lens-calibrated = Un étalonnage réel ajoute de l’incertitude, surtout loin de la mire.
planning-target-roof = Toit
planning-target-driver_eye = Œil du conducteur, côté proche
planning-target-driver_eye_far = Œil du conducteur, côté éloigné
planning-target-taillight = Feu arrière
planning-target-headlight = Projecteur

## Planification : données du plan

planning-picture-width_px = Largeur de l’image
planning-picture-height_px = Hauteur de l’image
planning-picture-field_of_view_deg = Champ horizontal
planning-camera-height = Hauteur de la caméra
planning-distance = Distance à la trace de roues
planning-board-distance = Distance à la mire
planning-usual-board_distance_m = trace de roues
planning-direction = Écart à la perpendiculaire
planning-sigma = Incertitude du pointé (u)
planning-travel = Parcours entre images
planning-camera = Caméra
planning-calibration = { $camera }, étalonnage { $id } du { $day }
planning-calibration-in-use = { $camera }, étalonnage { $id } du { $day } (en vigueur)
planning-calibration-unknown = étalonnage { $id }
planning-camera-plain = Une caméra sans étalonnage
planning-number-problem = Saisissez un nombre.
planning-lines-speed_mps = Vitesse maximale
planning-lines-error = Erreur admise (U95)
planning-lines-baseline_m = Base
planning-lines-u_baseline_m = u de la base
planning-lines-line_rate_hz = Cadence de lignes
planning-usual-line_rate_hz = 10 mm par ligne
planning-lines-length_m = Longueur du véhicule
planning-lines-time_gap_s = Intervalle temporel
planning-lines-pixel_width_um = Largeur du pixel
planning-lines-pixel_height_um = Hauteur du pixel
planning-lines-focal_mm = Focale
planning-lines-distance_m = Distance
planning-lines-exposure_us = Temps de pose
planning-usual-exposure_us = toute la ligne
unit-um = µm
unit-us = µs
unit-mm = mm

## Planification : le tableau des cibles

planning-targets-title = Incertitude attendue par cible
planning-target = Cible
planning-planned-height = Hauteur prévue
planning-inset = Retrait
planning-two-frames = U95, deux images
planning-inset-ignored = Biais si le retrait est ignoré
planning-targets-note = Les hauteurs sont des valeurs courantes ; les retraits sont ceux du relevé. Deux images : le véhicule a parcouru { $travel } entre les deux, et le retrait est calculé au lieu d’être supposé.
planning-parts-title = Bilan d’incertitude, une image
planning-parts-label = Bilan d’incertitude
planning-parts-source = Source
planning-parts-sum = Incertitude-type composée u

## Planification : temps de pose et images d’un passage

planning-passing-title = Temps de pose et images d’un passage
planning-passing-speed = Vitesse
planning-passing-exposure = Temps de pose maximal
planning-passing-blur = Flou à 1/1000 s
planning-passing-frames-30 = Images à 30/s
planning-passing-frames-60 = Images à 60/s
planning-passing-note = Temps de pose maximal : le véhicule s’y déplace de 2 px au milieu de l’image ; au-delà, les pointés sont moins précis. Images : celles où la chaussée et l’œil d’un conducteur sont visibles ; il en faut deux, dix suffisent à un passage entier.
planning-passing-px = { $blur } px
planning-passing-fraction = 1/{ $part } s
no-such-language = Il n’y a pas de rapport dans la langue « { $language } » ; choisissez parmi : { $known }.
planning-no-language = Il n’y a pas de fiche dans la langue « { $language } » ; choisissez parmi : { $known }.
planning-sheet = Fiche d’installation (PDF)

## La fiche d’installation : une page à emporter

sheet-title = Fiche d’installation
sheet-of = { $survey } · { $site }
sheet-lead = D’après la planification de Sightline, à l’échelle. Les hauteurs reposent sur ce qui est mesuré le jour même : notez-le dans la dernière colonne.
sheet-planned = Prévu
sheet-built = Sur place
sheet-camera-plain = Pas encore étalonnée, { NUMBER($degrees, maximumFractionDigits: 1) }° de champ
sheet-camera-value = { $name }, { $width_px } × { $height_px } px
sheet-metres = { NUMBER($metres, minimumFractionDigits: 2, maximumFractionDigits: 2) } m
sheet-metres-in-words = { $what } : { sheet-metres }
sheet-degrees = { NUMBER($degrees, maximumFractionDigits: 1) }°
sheet-millimetres = { NUMBER($millimetres, minimumFractionDigits: 1, maximumFractionDigits: 1) } mm
sheet-kmh = { NUMBER($kmh, maximumFractionDigits: 0) } km/h
sheet-blur = { NUMBER($pixels, minimumFractionDigits: 1, maximumFractionDigits: 1) } px
sheet-none = non mesurable
sheet-row = Rangée de référence de la mire au-dessus de la chaussée (mesurée deux fois)
sheet-zoom = Zoom et mise au point (bloqués)
sheet-exposure = Temps de pose, gain, balance des blancs (fixes)
sheet-start = Début de l’enregistrement, fuseau horaire
sheet-traffic = Circulation à droite ou à gauche ; volant ; caméra sur l’accotement ou le terre-plein
sheet-weather = Météo, éclairage public, vitesse limite
sheet-checks = Liste de contrôle
sheet-check-calibrated = Caméra étalonnée à ce zoom et à cette mise au point ; les deux bloqués
sheet-check-board = Case mesurée sur dix cases ; mire plane contre une règle
sheet-check-place = Alignement droit, chaussée plane ; contact des pneus dans l’image ; trépied lesté
sheet-check-exposure = Temps de pose, gain, mise au point et balance des blancs fixes ; flou sous 2 px
sheet-check-stood = Mire sur la trace de roues, perpendiculaire à la chaussée, ses rangées dans le sens du trafic
sheet-check-row = Rangée de référence mesurée deux fois, au millimètre
sheet-check-filmed = Mire filmée immobile cinq secondes, puis à une autre distance
sheet-check-watch = Une montre filmée, ou le début noté
sheet-check-own = Un véhicule de hauteurs connues passé devant la caméra
sheet-check-again = Mire filmée de nouveau à la fin, et chaque fois que la caméra a été touchée

## Planification : figures et dessins

planning-figure-distance-title = Incertitude élargie (95 %) selon la distance
planning-figure-distance-note = Une seule image, installation prévue. Les courbes s’arrêtent au bord du champ.
planning-figure-distance-label = U95 de véhicules à d’autres distances, U95 en { $small } selon la distance à la trace de roues en travers de la route en { $unit }
planning-figure-distance-x = Distance à la trace de roues ({ $unit })
planning-figure-distance-y = U95 ({ $unit })
planning-figure-bias-title = Biais de l’œil du conducteur si son retrait est ignoré
planning-figure-bias-note = Nul quand la caméra est à hauteur de l’œil.
planning-figure-bias-label = Erreur de l’œil du conducteur si son retrait est ignoré, erreur en { $small } selon la hauteur de la caméra au-dessus de la chaussée en { $unit }
planning-figure-bias-x = Caméra au-dessus de la chaussée ({ $unit })
planning-figure-bias-y = Erreur ({ $unit })
planning-figure-bar = La barre marque l’emplacement prévu.
planning-along-title = Le site, vu le long de la route
planning-along-note = À l’échelle. Le secteur est le champ vertical ; les points sont les cibles.
planning-along-label = Coupe : caméra { $camera_height } au-dessus de la chaussée, mire à { $board_distance }, trace de roues à { $distance }
planning-above-title = Le site vu de dessus
planning-above-note = À l’échelle. L’image montre { $shown } de la trace de roues avec la chaussée et l’œil d’un conducteur.
planning-above-label = Vue de dessus : la caméra vise en travers de la route, à angle droit, une voiture dans la voie
planning-above-label-turned = { $turned_deg ->
    [one] Vue de dessus : la caméra vise en travers de la route, tournée de { $turned_deg } degré le long de la route, une voiture dans la voie
   *[other] Vue de dessus : la caméra vise en travers de la route, tournée de { $turned_deg } degrés le long de la route, une voiture dans la voie
}
planning-wheel-track = trace de roues { $distance }
planning-wheel-track-and-board = trace de roues et mire { $distance }
planning-board = mire { $distance }

## Planification : la cadence de lignes

planning-speed-title = Incertitude attendue de la vitesse
planning-lines = À { $speed }, un véhicule met <strong>{ $lines } lignes</strong> de la caméra 1 à la caméra 2 à { $line_rate_hz } lignes par seconde, soit { $one_line } de route par ligne.
planning-speed-u = Incertitude-type : { $u_strips } due au recalage des bandes, { $u_baseline } due à la base. Résultat : <strong>{ $speed }</strong> (95 %).
planning-values-title = Incertitudes attendues
planning-values-note = pour un véhicule à cette vitesse derrière un autre aussi rapide, mesuré par la méthode par défaut
planning-values-quantity = Grandeur
planning-values-value = Valeur et U95
planning-values-strips = u des bandes
planning-values-baseline = u de la base
planning-values-edges = u de l’avant et de l’arrière
planning-values-speed = Vitesse
planning-values-length = Longueur
planning-values-time_gap = Intervalle temporel
planning-values-distance_gap = Distance intervéhiculaire
planning-ms = { $value } ms
planning-exposure-title = Pixels et temps de pose
planning-exposure-blur = Avec un temps de pose de { $exposure_us } µs, chaque ligne est floue sur <strong>{ $blur }</strong> de chaussée ; le véhicule parcourt { $line } d’une ligne à l’autre. Un pixel couvre { $width } le long de la chaussée et { $height } en hauteur : une arête verticale s’étale sur <strong>{ $smear }</strong>.
planning-exposure-shape = La hauteur d’un pixel est <strong>{ $shape }</strong> fois l’espacement des lignes. Une rangée de désalignement fausse la vitesse jusqu’à { $row_error } là où un détail est incliné à 45°.
planning-exposure-light = Une ligne reçoit <strong>{ $light }</strong> fois la lumière d’un pixel de 5 µm sur 5 µm exposé 1 ms derrière la même ouverture.
planning-exposure-dark = Peu de lumière : ouvrez le diaphragme, prenez des pixels plus grands ou un regroupement de pixels, ou une cadence de lignes plus basse.
planning-exposure-wide = Les pixels sont plus larges que deux espacements de lignes : une cadence plus élevée apporte peu. Prenez une focale plus longue.
planning-exposure-tall = Les pixels sont bien plus hauts que l’espacement des lignes : alignez les deux caméras à une fraction de rangée près, ou prenez plus de rangées.
planning-exposure-too-long = Un temps de pose de { $exposure_us } µs dépasse une ligne, { $line_us } µs ; saisissez-en un plus court ou une cadence de lignes plus basse.
planning-camera-cannot-be = { $name } de { $value } est hors plage. Saisissez une valeur supérieure à 0 et d’au plus { $most }.
planning-forms-title = Équation (2) de Douxchamps et al., imprimée et corrigée
planning-forms-label = Les deux formes de l’équation (2)
planning-forms-equation = Équation (2)
planning-forms-printed = Imprimée : son membre de droite
planning-forms-corrected = Corrigée : son terme central
planning-forms-error = Erreur de la vitesse
planning-forms-says = Remarque
planning-forms-says-printed = n + 2 lignes sont comptées au lieu de n, et l’écart est rapporté à n + 2. Les 6600 Hz imprimés en découlent ; les 1,3 % imprimés s’accordent avec les deux formes.
planning-forms-says-corrected = n + 2 lignes sont comptées au lieu de n, et l’écart est rapporté à n, comme dans le terme central 2 s / (b f). Un peu plus prudent.
planning-forms-line-rate = Cadence pour { $error }
planning-forms-line-rate-value = { $line_rate_hz } Hz
planning-forms-error-at = Erreur à { $line_rate_hz } Hz
planning-forms-error-value = { $error }, { $speed }
planning-forms-note = n = b f / s : les lignes de la caméra 1 à la caméra 2, pour la base b, la cadence de lignes f et la vitesse s. L’équation (2) est le cas le plus défavorable de passages lus à la ligne entière. Sightline recale les bandes à une fraction de ligne près et n’a pas besoin de ces cadences.

## Relevé : la vue d’ensemble

survey-loading = relevé
survey-demonstration = démonstration
survey-edit = Modifier
settings-lead = Site, trafic, cibles, échantillon, classes, normes et membres de ce relevé.
settings-site = Site, trafic, cibles et retraits
settings-traffic-unsaid = Le trafic n’est pas encore décrit.
settings-inset = { $inset } (u = { $u })
settings-members = Membres
settings-members-lead = Personnes qui peuvent voir ce relevé, et leurs rôles.
settings-classes = Classes de véhicules
settings-classes-lead = Classes comptées comme voitures particulières, utilitaires légers et poids lourds.
settings-standards-open = Ouvrir dans Résultats
settings-standards-lead = Hauteurs de projet affichées dans les figures.
members-open = Membres
members-invite = Inviter un nouvel utilisateur
members-title = Membres du relevé
members-lead = Seuls les membres et les administrateurs voient ce relevé.
members-lead-open = Toute personne connectée voit ce relevé et y agit selon le rôle de son compte. Les membres ont le rôle indiqué ici.
members-open-to-all = Ouvert à toute personne connectée
members-name = Nom
members-role = Rôle ici
members-role-of = Rôle de { $person } dans ce relevé
members-remove = Retirer
members-remove-title = Retirer { $person } du relevé ?
members-remove-body = { $person } ne le verra plus. Son travail reste à son nom.
members-remove-yourself = Vous ne verrez plus ce relevé.
members-none = Aucun membre pour l’instant.
members-inactive = désactivé
members-add = Ajouter
members-add-person = Personne
members-add-role = Rôle
members-choose = Choisir une personne
members-everybody = Toutes les personnes ayant un compte sont membres.
members-does-viewer = tout voir, exporter les archives
members-does-operator = ajouter des enregistrements, étalonner, mesurer
members-does-reviewer = ce que fait un opérateur, et vérifier le travail des autres
members-does-manager = ce que fait un vérificateur, et gérer les membres et le plan de vérification
members-admin = Un administrateur a tous les droits ici, quel que soit le rôle choisi.
members-loading = membres
survey-go-camera = Étalonner
survey-go-recordings = Ajouter
survey-go-pose = Calculer
survey-go-vehicles = Mesurer
survey-go-review = Vérifier
survey-go-results = Créer l’archive
survey-open = Ouvrir
survey-statistics = <link>Résultats</link> : centiles et leurs intervalles, normes, erreurs.
survey-traffic = La circulation est à { $traffic ->
    [right] droite
   *[left] gauche
}, le volant est d’ordinaire à { $steering ->
    [right] droite
   *[left] gauche
}, la caméra est { $camera ->
    [verge] sur l’accotement
   *[median] sur le terre-plein central
}.
survey-asked = Cibles de jour : { $daytime } ; en faible luminosité : { $low_light }.
survey-traffic-unsaid = Le côté de circulation et la position de la caméra ne sont pas définis. Les hauteurs d’œil seront calculées dès qu’ils le seront, aussi pour les pointés existants.
survey-traffic-say = Définir
overview-calibrated = { $count ->
    [one] Une caméra étalonnée.
   *[other] { NUMBER($count) } caméras étalonnées.
}
overview-calibrate = Étalonnez la caméra à partir de photos du damier, ou importez un étalonnage.
overview-add-camera = Ajoutez une caméra et étalonnez-la.
overview-ready = Enregistrements prêts : { NUMBER($count) } sur { NUMBER($all) }.
overview-confirm = { $count ->
    [one] Confirmez la luminosité et le début de 1 enregistrement.
   *[other] Confirmez la luminosité et le début de { NUMBER($count) } enregistrements.
}
overview-not-imported = Un enregistrement n’a pas pu être importé ; voyez le motif et envoyez-en un autre.
overview-importing = Attendez que l’enregistrement soit importé.
overview-drop-video = Déposez ici la vidéo du jour.
overview-posed = Chaque enregistrement a sa pose de la caméra.
overview-mark-board = { $count ->
    [one] Marquez les images où la mire est immobile dans un enregistrement.
   *[other] Marquez les images où la mire est immobile dans { NUMBER($count) } enregistrements.
}
overview-mark-board-later = Marquez les images où la mire est immobile, dès qu’un enregistrement est prêt.
overview-find-vehicles = Détectez les véhicules et mesurez sur chacun les cibles du relevé.
overview-measured = { $count ->
    [one] Le véhicule est mesuré ou non visible.
   *[other] Les { NUMBER($count) } véhicules sont mesurés ou non visibles.
}
overview-measure = Véhicules à mesurer : { NUMBER($left) } sur { NUMBER($count) }.
overview-not-visible = { $count ->
    [one] Une cible non visible.
   *[other] { NUMBER($count) } cibles non visibles.
}
overview-review = { $count ->
    [one] Vérifiez une mesure.
   *[other] Vérifiez { NUMBER($count) } mesures.
}
overview-review-line-heights = { $count ->
    [one] Vérifiez 1 hauteur de balayages.
   *[other] Vérifiez { NUMBER($count) } hauteurs de balayages.
}
overview-remeasure = { $count ->
    [one] Mesurez à nouveau une mesure rejetée.
   *[other] Mesurez à nouveau { NUMBER($count) } mesures rejetées.
}
overview-remeasure-line-heights = { $count ->
    [one] Mesurez à nouveau une hauteur de balayages rejetée.
   *[other] Mesurez à nouveau { NUMBER($count) } hauteurs de balayages rejetées.
}
overview-accepted = Validées : { $count ->
    [one] { NUMBER($count) } mesure
   *[other] { NUMBER($count) } mesures
}, { $scans ->
    [one] 1 hauteur de balayages.
   *[other] { NUMBER($scans) } hauteurs de balayages.
}
overview-reviewed = { $count ->
    [one] Une mesure vérifiée.
   *[other] { NUMBER($count) } mesures vérifiées.
}
overview-nothing-to-review = Rien à vérifier pour l’instant.
overview-packages = { $count ->
    [one] Une archive créée.
   *[other] { NUMBER($count) } archives créées.
}
overview-build-package = Créez l’archive des résultats.
overview-no-scans = Aucun ici. Deux caméras linéaires séparées d’une base connue donnent la vitesse, la longueur et les intervalles.
overview-scans-not-imported = { $count ->
    [one] Un balayage n’a pas pu être importé ; voyez le motif et réessayez.
   *[other] { NUMBER($count) } balayages n’ont pas pu être importés ; voyez le motif et réessayez.
}
overview-scans-importing = { $count ->
    [one] Import en cours : un balayage.
   *[other] Import en cours : { NUMBER($count) } balayages.
}
overview-scans-find = { $count ->
    [one] Détectez les véhicules d’un balayage.
   *[other] Détectez les véhicules de { NUMBER($count) } balayages.
}
overview-scans-review = { $open ->
    [one] Vérifiez { NUMBER($open) } véhicule sur { NUMBER($count) }.
   *[other] Vérifiez { NUMBER($open) } véhicules sur { NUMBER($count) }.
}
overview-scans-review-heights = { $open ->
    [one] Vérifiez { NUMBER($open) } hauteur sur { NUMBER($count) }.
   *[other] Vérifiez { NUMBER($open) } hauteurs sur { NUMBER($count) }.
}
overview-scans-accepted = { $all ->
    [one] Véhicules validés : { NUMBER($count) } sur 1 détecté.
   *[other] Véhicules validés : { NUMBER($count) } sur { NUMBER($all) } détectés.
}
overview-scans-not-measurable = Non mesurables : { NUMBER($count) } ; voyez les motifs.
overview-line-heights-accepted = Hauteurs validées : { NUMBER($count) } sur { NUMBER($all) }.
survey-scans-none = <link>Balayages</link> : { $summary }
survey-scans-label = Balayages linéaires, à part de ces étapes
survey-scan-results = <link>Mouvement</link> : vitesses, intervalles, longueurs par rapport à celles du constructeur.
survey-count-scans = { $count ->
    [one] balayage
   *[other] balayages
}
survey-count-recordings = { $count ->
    [one] enregistrement
   *[other] enregistrements
}
survey-count-vehicles = { $count ->
    [one] véhicule
   *[other] véhicules
}
survey-count-measured = sur { NUMBER($count) } mesurés ou non visibles
survey-count-accepted = { $count ->
    [one] validée
   *[other] validées
}
survey-count-rejected = { $count ->
    [one] rejetée
   *[other] rejetées
}
survey-count-scanned-accepted = { $count ->
    [one] validé
   *[other] validés
}
survey-count-measurements = { $count ->
    [one] mesure
   *[other] mesures
}

## Relevé : modification

survey-edit-title = Modifier le relevé
survey-name = Nom
survey-name-problem = Donnez un nom au relevé.
survey-site = Site
survey-description = Description
survey-insets = Retraits
survey-insets-help = Distance de chaque cible derrière le plan des flancs extérieurs des pneus, à l’opposé de la caméra. Sert aux nouvelles mesures ; la seconde valeur est son incertitude-type.
survey-insets-target = Cible
survey-insets-inset = Retrait ({ $unit })
survey-insets-u = u ({ $unit })
survey-inset-label = { $target } : retrait en { $unit ->
    [ft] pieds
   *[m] mètres
}
survey-inset-u-label = { $target } : incertitude en { $unit ->
    [ft] pieds
   *[m] mètres
}
survey-inset-problem = { $target } : saisissez le retrait et son incertitude en { $unit ->
    [ft] pieds
   *[m] mètres
}, par exemple { $inset } et { $u_inset }.

## Relevé : photos de l’installation

photographs-title = Photos de l’installation
photographs-help = Le dispositif, la route, la mire en place. Affichées dans le rapport et l’archive.
photographs-choose = Choisir des photos à ajouter
photographs-drop = Déposez des photos ici, ou choisissez-les
photographs-adding = Ajout de { NUMBER($count) }…
photographs-hint = JPEG, PNG, WebP ou TIFF. Réduites à 1600 px ; données de localisation retirées.
photographs-open = Ouvrir { $photograph }
photographs-what = Ce qu’elle montre
photographs-caption = Légende de { $photograph }
photographs-left = Déplacer { $photograph } vers la gauche
photographs-right = Déplacer { $photograph } vers la droite
photographs-remove = Retirer { $photograph }
photographs-removed = Photo retirée : { $photograph }.

## Relevés : la page

surveys-lead = Un relevé par site et par campagne.
surveys-loading = relevés
surveys-new = Nouveau relevé
surveys-new-make = Créer le relevé
surveys-new-name = Nom
surveys-new-name-example = Rouen sud, voie 1
surveys-new-name-problem = Donnez un nom au relevé, par exemple la route et la voie.
surveys-new-site = Site
surveys-new-site-example = D938, km 12,4, vers le sud
surveys-new-description = Description
surveys-new-description-hint = Notes pour qui ouvrira ce relevé plus tard.
surveys-choose-password = Choisir un mot de passe
surveys-link-used = Définissez un mot de passe pour pouvoir vous reconnecter. Votre lien a déjà servi.
surveys-demo-failed = Le relevé de démonstration n’a pas pu être créé.
surveys-demo-first = Le relevé de démonstration est le rendu d’une scène connue : chaque hauteur peut être comparée à sa valeur vraie. Essayez-y d’abord Sightline, puis créez votre propre relevé.
surveys-demo-open = Ouvrir le relevé de démonstration
surveys-demo-title = Relevé de démonstration
surveys-demo-being-made = création en cours
surveys-demo-wait = Rendu d’une route, d’un damier et d’une quarantaine de véhicules ; cela prend environ une minute.
surveys-none-title = Aucun relevé
surveys-none-make = Créez un relevé pour un site, puis étalonnez sa caméra, ajoutez la vidéo de la journée et mesurez. Le relevé de démonstration contient déjà tout cela.
surveys-none = Aucun relevé. Un opérateur peut créer le premier.
studies-lead = Relevés de plusieurs sites et années réunis : hauteurs du parc avec leur incertitude totale, et leur effet sur les normes.
studies-loading = études
studies-new = Nouvelle étude
studies-new-make = Créer l’étude
studies-none-title = Aucune étude
studies-none = Une étude réunit les relevés de plusieurs sites, pondère leurs véhicules selon le parc et donne l’incertitude de ses centiles.
studies-name = Étude
studies-surveys = Relevés
studies-sites = Sites
studies-heights = Hauteurs
studies-computed = Calculée
studies-not-computed = non calculée
study-loading = étude
study-simulated = simulée
study-none-counts = { $name } n’a pas de hauteur validée qui compte ; il ne contribue pas.
study-versions = Les archives viennent de { NUMBER($count) } versions aux tables identiques : { $versions }.
study-one-site = Un seul site : les intervalles ne valent que pour lui.
study-outside-sample = { NUMBER($count) } hauteurs validées sont de véhicules hors de l’échantillon de leur relevé ; elles ne comptent pas.
study-without-class = { NUMBER($count) } hauteurs { $target ->
    [roof] de toits
    [driver_eye] d’yeux de conducteur
    [taillight] de feux arrière
    [headlight] de projecteurs
   *[other] d’autres points
} n’ont pas de classe du parc ; elles ne comptent pas.
study-sites-unlike = { $target ->
    [roof] Toits
    [driver_eye] Yeux de conducteur
    [taillight] Feux arrière
    [headlight] Projecteurs
   *[other] Autres points
} : les sites diffèrent de plus de la moitié de ce dont diffèrent leurs véhicules. Les intervalles de centiles loin de la médiane contiennent alors la vraie valeur dans moins de 95 % des cas ; mesurez à plus de sites, ou réunissez en une strate les sites d’une même sorte.
study-all-simulated = Simulée : aucune valeur ne décrit des routes réelles.
study-some-simulated = { NUMBER($count) } relevés sur { NUMBER($surveys) } sont simulés : aucun chiffre de l’étude ne dit rien de routes réelles.
study-heights-needed = ses chiffres demandent au moins { $least } hauteurs
study-no-weights = aucun poids ne satisfait à la fois toutes les parts du parc
study-one-site-of-stratum = { $stratum } n’a qu’un site : réunissez-la à une autre strate, pour que l’écart entre sites puisse être estimé
study-class-not-counted = le parc contient { $variable } { $name }, dont aucune hauteur ne compte
study-class-at-one-site = une strate n’a sa classe que sur un site : l’écart entre sites ne peut pas être estimé
study-simulated-note = Simulée : rien n’a été filmé. Les véhicules ont été tirés de parcs connus ; aucune valeur ne décrit des routes réelles.
study-name = Nom
study-description = Description
study-report = Rapport (PDF)
study-package = Archive de l’étude
study-compute = Calculer
study-compute-again = Recalculer
study-computed = L’étude est calculée.
study-old-study = L’étude a été modifiée après le calcul de ces valeurs. Recalculez-la.
study-old-surveys = Des données ont changé après le calcul de ces valeurs, dans { $surveys }. Recalculez l’étude.
study-empty-title = Aucun relevé
study-empty = Ajoutez les relevés que l’étude réunit ; chacun a un site, et peut avoir une strate et une année.
study-add-surveys = Ajouter des relevés
study-not-computed-title = Pas encore calculée
study-not-computed = Calculez l’étude pour voir ses résultats.
study-made = Calculée le { $moment } par { $person } avec Sightline { $version } ; SHA-256 de l’archive { $hash }.
study-made-by-system = Sightline
study-joined = Relevés
study-edit = Modifier
study-edit-title = Modifier l’étude
study-remove = Retirer l’étude
study-remove-now = Retirer
study-remove-words = { $name } est retirée de la liste des études. Ses relevés ne changent pas, et ses résultats restent conservés.
study-members = Membres de cette étude
study-members-note = Les membres voient l’étude, son archive et son rapport tant qu’ils voient chacun de ses relevés. Une personne qui gère tous ces relevés peut la rendre visible à toute personne connectée. Les administrateurs voient toutes les études.
study-members-open = Visible pour toute personne connectée
study-members-add = Ajouter un membre
study-members-choose = Choisir une personne
study-members-nobody = Tout le monde est déjà membre
study-members-remove = Retirer { $name }
study-survey = Relevé
study-site = Site
study-stratum = Strate
study-year = Année
study-counted = Hauteurs retenues
study-outside = Hors échantillon
study-weighted = Les hauteurs sont pondérées selon le parc fourni.
study-not-weighted = Aucun parc fourni : les véhicules ne sont pas pondérés.
study-sites-known = Les strates, les nombres de sites et le trafic suivent le tableau des sites.
study-sites-unknown = Aucun tableau des sites fourni : chaque strate est supposée avoir un très grand nombre de sites de trafic égal.
study-goal-is = Planifiée pour une U95 de { $goal } sur P10.
study-fleet = Parc (CSV)
study-fleet-hint = Colonnes category et share (ou registrations) ; plusieurs types : variable, class, share. Vide : sans pondération.
study-sites = Sites (CSV)
study-sites-hint = Colonnes site et stratum ; sites_there et traffic s’ils sont connus. Vide : strates indiquées avec les relevés.
study-goal = U95 visée pour P10
study-goal-unit = mm
study-goal-hint = Pour planifier une étude ultérieure.
study-take-out = Retirer { $name }
study-add-survey = Ajouter un relevé
study-choose-survey = Choisir un relevé
study-no-more-surveys = Pas d’autre relevé
study-surveys-hint = Les relevés d’un même site forment une grappe. Les années sont comparées s’il y en a au moins deux.
study-choose-file = Choisir un fichier
study-choose-file-of = Choisir un fichier : { $table }
study-counted-words = { NUMBER($heights) } hauteurs validées de { NUMBER($vehicles) } véhicules sur { $sites ->
    [one] { $sites } site
   *[other] { $sites } sites
}.
study-percentiles = Centiles des hauteurs vraies ({ $unit })
study-holds = Sous chaque valeur, son intervalle total à 95 % : échantillonnage des véhicules et des sites, erreurs communes aux hauteurs (pose de la caméra, retrait moyen). L’erreur de mesure aléatoire est retirée des valeurs.
study-target = Cible
study-n = n = { NUMBER($n) }
study-mean = Moyenne
study-sd = Écart-type
study-effects = Effets de plan
study-effects-note = Effet de plan : variance de ce plan divisée par celle d’un échantillon aléatoire simple de même taille. n effectif : nombre de hauteurs divisé par l’effet de plan. Tous deux sont estimés d’après les écarts entre sites : avec peu de sites, ils sont grossiers. Un effet de plan inférieur à 1 (un n effectif supérieur au nombre de véhicules) relève alors du hasard.
study-figure = Grandeur
study-vehicles = Véhicules
study-effect = Effet de plan
study-effective = n effectif
study-weighting = Poids seuls
study-years = Années comparées
study-years-note = Année la plus récente moins la première, chacune pondérée à part, avec intervalles totaux à 95 %. Une différence est dite plus haute ou plus basse si son intervalle exclut 0. Les erreurs sont supposées indépendantes entre les années ; si elles en ont en commun, les intervalles sont trop larges, jamais trop étroits.
study-years-column = Années
study-years-of = { $first } à { $second }
study-beside = Comparaison avec une autre étude
study-beside-with = Comparer avec
study-beside-none = Aucune autre étude avec des résultats
study-beside-choose = Choisissez une étude
study-beside-loading = comparaison
study-beside-title = { $second } moins { $first }
study-beside-note = Utilise les derniers résultats de chaque étude, avec intervalles totaux à 95 %. Une différence est dite plus haute ou plus basse si son intervalle exclut 0 (risque d’au plus 2,5 % de chaque côté, pour chaque valeur séparément). Les erreurs sont supposées indépendantes entre les études ; si elles en ont en commun (un site, un retrait moyen), les intervalles sont trop larges.
study-beside-shared = Les deux études contiennent { $surveys }. Les erreurs communes s’annulent en partie : ces intervalles sont trop larges.
study-errors = Erreur par rapport aux hauteurs du constructeur
study-errors-note = Mesure moins hauteur du constructeur des toits, sans arrondi, avec intervalles de confiance à 95 %.
study-lighting = Luminosité
study-bias = Biais
study-all = toutes
study-classes = Classes de véhicules
study-classes-note = Parts de l’échantillon, avec IC à 95 %, comparées au parc.
study-class = Classe
study-share = Part
study-fleet-share = Parc
study-plan = Étude suivante : U95 de P10 dans la limite de { $goal }
study-plan-note = Véhicules nécessaires sur chaque site, si sites et véhicules varient comme ici. Hors d’atteinte : sur si peu de sites, aucun nombre de véhicules ne suffit.
study-plan-sites = Sites
study-plan-none = hors d’atteinte
study-curve-title = { $target } : hauteurs vraies
study-curve-says = Fonction de répartition des hauteurs vraies, { $target }, avec sa bande.
study-curve-note = La bande joint les intervalles totaux à 95 % des centiles. Tirets : erreur aléatoire comprise.
study-curve-true = hauteurs vraies
study-curve-raw = erreur aléatoire comprise

surveys-card = <made>{ $recordings ->
    [one] { $recordings } enregistrement
   *[other] { $recordings } enregistrements
} · { $day }</made>
surveys-card-with-site = { $site } · <made>{ $recordings ->
    [one] { $recordings } enregistrement
   *[other] { $recordings } enregistrements
} · { $day }</made>
surveys-vehicles-measured = Véhicules mesurés ou non visibles
surveys-heights-reviewed = Hauteurs vérifiées{ $scans ->
    [0] { "" }
   *[other] { "" } (images et balayages)
  }
surveys-scans-reviewed = Véhicules de balayages vérifiés
surveys-scans = Balayages : { $summary }
surveys-simulated = { $count ->
    [one] Étude simulée : 1 relevé
   *[other] Étude simulée : { NUMBER($count) } relevés
}
surveys-simulated-help = Rien n’a été filmé ici ; ces relevés illustrent les statistiques, les normes et les <link>études</link>.
surveys-all-done = Tout est terminé
surveys-tally = { NUMBER($done) } <muted>sur { NUMBER($all) }</muted>

## Connexion : la page

signin-loading = votre compte
signin-link-title = Votre lien de connexion
signin-with-password = Se connecter par mot de passe
signin-email = E-mail
signin-password = Mot de passe
signin-submit = Se connecter
signin-help = Pas encore de mot de passe ? Utilisez le lien à usage unique : le serveur l’affiche à son premier démarrage, et un administrateur en crée un pour chaque nouvelle personne.

## Compte : la page

account-name = Nom
account-email = E-mail
account-role = Rôle
account-password-change = Changer le mot de passe
account-password-choose = Choisir un mot de passe
account-no-password = Vous n’avez pas encore de mot de passe ; sans lui, il vous faut un nouveau lien à chaque connexion.
account-password-present = Mot de passe actuel
account-password-new = Nouveau mot de passe
account-password-hint = Au moins { NUMBER($least) } caractères ; quelques mots à la suite se retiennent facilement.
account-password-short = { $count ->
    [one] Il a { NUMBER($count) } caractère ; il en faut au moins { NUMBER($least) }.
   *[other] Il a { NUMBER($count) } caractères ; il en faut au moins { NUMBER($least) }.
}
account-password-again = Confirmer le mot de passe
account-password-differs = Les mots de passe diffèrent. Saisissez deux fois le nouveau.
account-password-set = Définir le mot de passe
account-password-is-set = Votre mot de passe est défini.
account-tokens = Jetons d’API
account-tokens-loading = vos jetons
account-tokens-none = Aucun jeton
account-tokens-help = Un jeton permet à un programme, tel qu’un script ou sightline import, de faire une partie de ce que vous pouvez faire.
account-token-make = Créer un jeton
account-token-make-action = Créer
account-token-name = Nom
account-token-scopes = Droits
account-token-ends = Expire
account-token-used = Dernier usage
account-token-ended = expiré
account-token-never = jamais
account-token-revoke = Révoquer
account-token-revoke-title = Révoquer { $name } ?
account-token-revoke-body = Les programmes qui l’utilisent seront désormais refusés ; c’est irréversible.
account-token-title = Jeton { $name }
account-token-once = Copiez-le maintenant dans le programme ; il ne sera plus affiché. Quiconque le détient agit en votre nom.
account-token = Jeton
account-token-copied = Le jeton est dans le presse-papiers.
account-token-name-field = Nom
account-token-name-hint = Le programme et l’ordinateur où il s’exécute.
account-token-name-problem = Saisissez un nom qui dit à quoi sert le jeton.
account-token-scopes-field = Droits
account-token-scopes-problem = Choisissez-en au moins un.
account-token-days = Expire après
account-token-days-count = { $days ->
    [one] { $days } jour
    [366] un an
   *[other] { $days } jours
}
token-scope-read = lire
token-scope-hint-read = Voir ce que vous voyez, et calculer des hauteurs sans les enregistrer.
token-scope-upload = envoyer
token-scope-hint-upload = Ajouter des enregistrements et détecter leurs passages.
token-scope-measure = mesurer
token-scope-hint-measure = Le reste de ce que fait un opérateur : relevés, caméras, poses, mesures.
token-scope-review = vérifier
token-scope-hint-review = Rendre des décisions et statuer sur les lots.
token-scope-export = exporter
token-scope-hint-export = Créer et télécharger les archives et les résultats d’études.
show-once-copy = Copier
show-once-done = Terminé

## Personnes : la page

people-only-admin = Seul un administrateur peut voir et modifier les comptes ; adressez-vous à lui s’il vous faut un autre rôle.
people-lead = Comptes et rôles. Une personne voit les relevés ouverts à tous et ceux dont elle est membre ; les administrateurs voient tous les relevés.
people-loading = utilisateurs
people-add = Ajouter un utilisateur
people-name = Nom
people-role = Rôle
people-state = État
people-last-seen = Dernière connexion
people-actions = Actions
people-you = (vous)
people-role-of = Rôle de { $person }
people-no-password = sans mot de passe
people-never = jamais
people-new-link = Nouveau lien
people-switch-off = Désactiver
people-switch-on = Réactiver
people-role-title = Donner à { $person } le rôle { $role } ?
people-role-body = { $person } pourra alors : { $does }
people-role-change = Changer le rôle
people-switch-off-title = Désactiver le compte de { $person } ?
people-switch-off-body = Cette personne est déconnectée et ne pourra plus se connecter ; ses mesures et vérifications restent à son nom.
people-does-viewer = voir les relevés ouverts à tous et ceux dont la personne est membre, exporter les archives
people-does-operator = ajouter des enregistrements, étalonner, mesurer
people-does-reviewer = ce que fait un opérateur, et vérifier le travail des autres
people-does-admin = tout, y compris gérer les comptes

## Personnes : en ajouter une

people-add-action = Ajouter
people-add-name = Nom
people-add-name-problem = Donnez le nom de la personne tel qu’il doit figurer à côté de son travail.
people-add-email = E-mail
people-add-email-hint = Sert à se connecter. Sightline n’envoie pas d’e-mail : vous transmettez le lien affiché ensuite.
people-add-email-problem = Donnez une adresse e-mail, par exemple ada@example.org.
people-add-role = Rôle
people-link-title = Lien de connexion de { $person }
people-link-help = Envoyez ce lien à { $person }. Il sert une seule fois, expire dans 7 jours et ne sera plus affiché.
people-link = Lien de connexion
people-link-copied = Le lien est dans le presse-papiers.

## Audit : la page

audit-lead = Chaque modification est un événement d’une chaîne de hachage. Toute retouche ou suppression ultérieure rompt la chaîne.
audit-numbers = Chaque relevé a sa propre chaîne ; les modifications hors relevé en ont une autre. Les numéros comptent les événements d’une chaîne : une liste filtrée a des trous. Contrôlez la chaîne pour savoir s’il en manque.
audit-loading = journal d’audit
audit-survey = Relevé
audit-survey-all = Tous
audit-what = Objet modifié
audit-what-all = Tout
audit-none-title = Aucun événement ici
audit-none-filtered = Aucun événement ne correspond aux filtres.
audit-none = Aucune modification enregistrée.
audit-events = Événements d’audit
audit-number = N°
audit-when = Quand
audit-who = Qui
audit-did = Action
audit-changes = Modifications
audit-hash = Empreinte
audit-older = Événements plus anciens
audit-hash-after = { $hash }, après { $previous }
audit-hash-first = { $hash }, premier événement
audit-check = Contrôler la chaîne
audit-whole-title = La chaîne est intacte
audit-whole = { $count ->
    [one] { NUMBER($count) } événement contrôlé ; la dernière empreinte est <code>{ $hash }</code>.
   *[other] { NUMBER($count) } événements contrôlés ; la dernière empreinte est <code>{ $hash }</code>.
}
audit-event-missing = L’événement d’audit { $number } de { $chain } manque ; restaurez une sauvegarde.
audit-event-changed = L’événement d’audit { $number } de { $chain } a été modifié après son écriture ; restaurez une sauvegarde.
audit-event-incomplete = L’événement d’audit { $number } de { $chain } n’a pas ce qu’un tel événement contient ; restaurez une sauvegarde.
audit-chain-ends-elsewhere = La chaîne d’audit de { $chain } se termine à l’événement { $number }, ce qui n’est pas sa vraie fin ; restaurez une sauvegarde.
audit-chains-not-signed = Les chaînes d’audit ne sont pas celles signées le { $at } ; restaurez une sauvegarde.
audit-no-checkpoint = Ce n’est pas un point de contrôle, ou sa signature n’est pas valable ; indiquez le fichier écrit par `sightline checkpoint`, ou le checkpoint.json d’une archive.
audit-checkpoint-elsewhere = Le point de contrôle du { $at } n’a pas signé la chaîne d’audit de cette archive : il est d’un autre relevé ou d’une autre installation, ou d’avant ce relevé.
audit-chain-ends-before = La chaîne d’audit { $chain } finit à l’événement { NUMBER($last) }, avant l’événement { NUMBER($event) } qu’a signé le point de contrôle du { $at } : elle a été coupée, est plus ancienne que le point de contrôle, ou vient d’une autre installation.
audit-chain-differs = L’événement { NUMBER($event) } de la chaîne d’audit { $chain } n’est pas celui qu’a signé le point de contrôle du { $at } : la chaîne a été réécrite, ou vient d’une autre installation.
audit-vouched-events = Ce qui a été indiqué garantit { NUMBER($vouched) } des { NUMBER($count) } événements, non ceux qui ont suivi.
audit-chain-not-exported = La chaîne d’audit n’est pas celle de l’export { $id } ; restaurez une sauvegarde.
audit-row-not-events = { audit-thing } { $id } diffère de ses événements ; restaurez une sauvegarde.
audit-row-not-first = { audit-thing } { $id } diffère de ce qui a été écrit à l’origine ; restaurez une sauvegarde.
audit-row-removed = { audit-thing } { $id } a disparu sans événement d’audit ; restaurez une sauvegarde.
audit-thing = { $entity ->
    [calibration] L’étalonnage
    [click_sigma] L’incertitude de pointé
    [computing] Le recalcul de hauteurs
    [frames] La table d’images de l’enregistrement
    [line_pose] L’étalonnage d’une caméra linéaire
    [lot] Le lot
    [lot_decision] La décision sur un lot
    [lot_items] Le contenu du lot
    [measurement] La révision d’une mesure
    [photograph] La photo de l’installation
    [pose] La pose de la caméra
    [review] La vérification
    [rig_calibration] L’étalonnage du dispositif
    [scan] Le balayage
    [scan_measurement] La mesure d’un véhicule balayé
    [scan_reference] La valeur de référence d’un véhicule balayé
    [scan_review] La vérification d’un véhicule balayé
    [scan_run] La détection dans un balayage
    [scan_vehicle] Le véhicule balayé
    [series] La mesure
    [study] L’étude
    [study_result] Le résultat d’une étude
    [wheel_pair] La paire de contacts de pneus
   *[vehicle] Le véhicule
}
audit-broken-title = La chaîne est rompue

## Audit : ce qui a été fait, et à quoi

audit-action-calibrate = étalonnage :
audit-action-cancel = annulation :
audit-action-cancelled = arrêt :
audit-action-check_drift = contrôle de stabilité de la caméra :
audit-action-choose = choix :
audit-action-choose_calibration = choix de l’étalonnage :
audit-action-create = création :
audit-action-decide_drift = décision sur la stabilité de la caméra :
audit-action-delete = suppression :
audit-action-detect = détection de la mire :
audit-action-draw = tirage :
audit-action-done = fin :
audit-action-failed = échec :
audit-action-finish = achèvement :
audit-action-fix = correction :
audit-action-import = import :
audit-action-ingest = import :
audit-action-ingest_failed = échec de l’import :
audit-action-order = mise en ordre :
audit-action-propose = établissement :
audit-action-read = lecture :
audit-action-recorded = enregistrement :
audit-action-reading_failed = échec de la lecture :
audit-action-release = remise en file :
audit-action-requeue = remise en file :
audit-action-request = demande de statistiques :
audit-action-restart_ingest = reprise de l’import :
audit-action-restart_reading = reprise de l’import :
audit-action-restore = restauration :
audit-action-retire = mise hors catalogue :
audit-action-review = vérification :
audit-action-revise = modification :
audit-action-revoke = révocation :
audit-action-run = exécution :
audit-action-seal = scellement :
audit-action-set_password = choix du mot de passe :
audit-action-sign = signature :
audit-action-take = adoption :
audit-action-sign_out = déconnexion :
audit-action-swap_cameras = échange des caméras :
audit-action-take_back_drift_decision = annulation de la décision sur la stabilité de la caméra :
audit-action-update = modification :
audit-action-use = utilisation :
audit-action-compute_again = recalcul :
audit-action-undo = annulation :
audit-action-accepted = acceptation :
audit-action-full_inspection = renvoi au contrôle complet :
audit-action-dissolved = dissolution :
audit-action-taken_back = annulation :
audit-action-withdraw = retrait :
audit-entity-survey = relevé
audit-entity-survey_member = membre
audit-entity-camera = caméra
audit-entity-calibration_image = photo d’étalonnage
audit-entity-calibration = étalonnage
audit-entity-recording = enregistrement
audit-entity-upload = envoi
audit-entity-pose = pose
audit-entity-photograph = photo
audit-entity-catalogue = catalogue
audit-entity-vehicle = véhicule
audit-entity-measurement = mesure
audit-entity-proposals = propositions de pointés
audit-entity-review = décision
audit-entity-computing = hauteurs recalculées
audit-entity-review_plan = plan de vérification
audit-entity-free_plan = véhicules mesurés sans propositions
audit-entity-wheel_pair = paire de roues
audit-entity-click_sigma = incertitude du pointé
audit-entity-standards = normes
audit-entity-scan = balayage
audit-entity-scan_run = analyse du balayage
audit-entity-lot = lot
audit-entity-lot_decision = décision sur un lot
audit-entity-scan_vehicle = véhicule du balayage
audit-entity-scan_measurement = mesure du balayage
audit-entity-scan_review = vérification du balayage
audit-entity-scan_reference = valeur de référence
audit-entity-line_pose = pose de la caméra linéaire
audit-entity-rig_calibration = étalonnage du dispositif
audit-entity-export = export
audit-entity-evidence = dossier de preuve
audit-entity-study = étude
audit-entity-study_result = résultat d’une étude
audit-entity-study_member = membre d’une étude
audit-entity-package = archive
audit-entity-checkpoint = point de contrôle
audit-entity-signing_key = clé de signature
audit-entity-person = personne
audit-entity-sign_in_link = lien de connexion
audit-entity-api_token = jeton d’API
audit-entity-job = tâche
audit-subject-vehicle = véhicule { $vehicle }
audit-subject-target = véhicule { $vehicle }, { $target ->
    [roof] toit
    [driver_eye] œil du conducteur
    [taillight] feu arrière
    [headlight] projecteur
   *[other] autre
}
audit-subject-verdict = { $subject } ({ $verdict })
audit-subject-named = { $entity } « { $name } »
audit-person = Personne
audit-person-all = Toutes
audit-day = Jour (UTC)
audit-vehicle = Numéro du véhicule
audit-vehicle-problem = Saisissez un nombre entier.
audit-row = ligne { $id } de la base de données

## Export : la page

excluded-withdrawn = La mesure a été retirée.
excluded-not-reviewed = Elle n’est pas encore vérifiée.
excluded-not-selected = Elle ne fait pas partie des véhicules de cette archive.
excluded-no-height = Il n’y a pas de hauteur.
excluded-rejected = Elle a été rejetée par un vérificateur.
excluded-reopened = Elle a été rouverte et attend une nouvelle vérification.
excluded-check-target = Elle contrôle la mesure : ses erreurs sont dans statistics/errors_by_target.csv.
excluded-without-time = Cette archive porte sur certains jours ou heures de prise de vue, et le début de son enregistrement n’est pas confirmé.
excluded-out-of-sample = Son véhicule est hors de l’échantillon du relevé.
export-lead = Téléchargez les données, le rapport et le journal d’audit.
export-crops = avec les images des pointés
export-of-title = Véhicules des statistiques et du rapport
export-of-lighting = Luminosité
export-of-filmed-from = filmés à partir du { $day }
export-of-filmed-to = filmés jusqu’au { $day }
export-of-hours = filmés entre { $begins } et { $ends }
export-of-nights = { $days ->
    [one] filmés dans la nuit qui commence le { $first }, de { $begins } à { $ends }
    [since] filmés dans les nuits qui commencent à partir du { $first }, de { $begins } à { $ends }
    [until] filmés dans les nuits qui commencent jusqu’au { $last }, de { $begins } à { $ends }
   *[several] filmés dans les nuits qui commencent du { $first } au { $last }, de { $begins } à { $ends }
}
export-of-help = Les statistiques, les figures et le rapport ne portent que sur ces véhicules, comme l’indique la première page du rapport ; le trafic des balayages n’est limité que par les jours et les heures, car le débit et les temps intervéhiculaires comprennent tous les véhicules. Les tableaux sont complets, pour que le journal d’audit les couvre ; exclusions.csv nomme ce qui est exclu.
export-of = Véhicules
export-of-all = tous les véhicules
export-build = Créer l’archive
export-ready = L’archive est prête.
export-failed = L’archive n’a pas pu être créée ; réessayez.
export-open-note = Chaque ligne indique son état de vérification. Pour une archive définitive, <link>terminez d’abord la vérification</link>.
export-packages = Archives
export-outdated = Périmée, depuis : { $what }
export-since-heights = { $count ->
    [one] { NUMBER($count) } hauteur
   *[other] { NUMBER($count) } hauteurs
}
export-since-reviews = { $count ->
    [one] { NUMBER($count) } décision
   *[other] { NUMBER($count) } décisions
}
export-since-other = { $count ->
    [one] { NUMBER($count) } autre changement
   *[other] { NUMBER($count) } autres changements
}
export-loading = archives
export-none-title = Aucune archive
export-none = Appuyez sur « Créer l’archive ». Cela prend de quelques secondes à quelques minutes, selon le nombre d’images. Vous pouvez continuer à travailler.
export-made = Créée
export-language = Langue du rapport
export-size = Taille
export-sha256 = SHA-256
export-audit-head = Tête d’audit de l’archive
export-download-column = Téléchargement
export-download = Télécharger
export-sha256-copy = Copier le SHA-256
export-sha256-copied = Le SHA-256 est dans le presse-papiers.
export-audit-head-copy = Copier la tête d’audit
export-audit-head-copied = La tête d’audit est dans le presse-papiers.
export-checking = Vérifier une archive
export-checking-help = Contrôle chaque fichier, la chaîne d’audit, sa signature et chaque ligne par rapport à elle, et recalcule chaque hauteur et chaque statistique. Transmettez la clé de cette installation (ou le SHA-256) séparément de l’archive. Elle révèle une archive remplacée et signée avec une autre clé. Une signature prouve ce que le détenteur de la clé a signé, non que cela est vrai.
export-command-copy = Copier la commande
export-command-copied = La commande est dans le presse-papiers.

## Export : contenu d’une archive

export-contents = Contenu d’une archive
export-contents-report = installation, étalonnage, méthode, erreurs, figures et exclusions en quelques pages
export-contents-measurements = mesures en vigueur : véhicule, cible, image, hauteur et son incertitude
export-contents-exclusions = mesures exclues et motifs
export-contents-statistics = tableau d’erreurs, centiles, distributions et corrections en CSV ; figures en SVG
export-contents-crops = l’image de chaque mesure, sans marque et avec ses points
export-contents-revisions = chaque révision avec ses pointés et son bilan d’incertitude
export-contents-clicks = les pointés seuls : « sightline height » en calcule les mêmes hauteurs
export-contents-vehicles = marque, modèle, année, hauteur du constructeur et sa source, luminosité
export-contents-recordings = empreintes des fichiers, horodatage et somme de contrôle de chaque image mesurée
export-contents-poses = poses de la caméra et paramètres de l’objectif, en tableaux et en JSON
export-contents-classes = classes de véhicules avec leurs groupes ; véhicules sur lesquels portent les statistiques et le rapport
export-contents-insets = retraits en vigueur ; les deux pneus d’un véhicule, pour son sens de circulation
export-contents-reviews = décisions et motifs, et répétitions en aveugle
export-contents-audit = chaque modification avec son empreinte ; la chaîne peut être contrôlée
export-contents-datapackage = nom, unité et signification de chaque colonne (Frictionless Data)

## Propositions : pourquoi un point d’un véhicule qui passe n’est pas proposé (conservées par clé)

proposals-not-across = Le véhicule monte ou descend dans l’image. Les propositions demandent un véhicule qui la traverse.
proposals-no-empty-road = Trop peu d’images avant et après le véhicule pour reconnaître la route vide.
proposals-not-one-vehicle = Les roues trouvées sur plusieurs images n’appartiennent pas à un même véhicule.
proposals-wheels-on-few-frames = Les roues se détachent de l’ombre et de la caisse sur trop peu d’images.
proposals-wheel-on-best-frame = Cette roue ne se détache pas de l’ombre et de la caisse sur la meilleure image.
proposals-not-in-picture = N’est pas dans le champ sur la meilleure image.
proposals-no-wheel = Aucune roue ne se détache de l’ombre et de la caisse sur ces images.
proposals-no-height = Aucune hauteur ne résulte de ce point ; pointez-le vous-même.
proposals-roof-not-seen = Le bord proche du toit n’a été détecté que sur trop peu d’images ; pointez-le vous-même.
proposals-taillight-not-seen = Le feu arrière n’a été détecté que sur trop peu d’images ; pointez vous-même son bord inférieur.
proposals-headlight-by-hand = Le milieu d’un projecteur n’est pas encore détecté de façon fiable ; pointez-le vous-même.
proposals-eye-not-seen = L’œil du conducteur n’a été détecté que sur trop peu d’images ; si vous le voyez, pointez-le vous-même.
proposals-hidden-here = N’est pas visible sur la meilleure image.
proposals-no-contact = Aucun contact de pneu n’est proposé sur cette image, donc aucune hauteur n’en résulterait ; pointez les deux vous-même.
proposals-too-uncertain = N’a pas été localisé assez précisément pour une hauteur ; pointez-le vous-même.

## Propositions : la tâche, et ce qui est refusé

proposals-looking = Recherche de points à proposer.
proposals-made = Propositions pour { NUMBER($some) } passages sur { NUMBER($passes) }, points en tout : { NUMBER($points) }.
proposals-being-made-already = Les propositions pour { $name } sont déjà en cours ; attendez la fin.
proposals-no-found-passes = { $name } n’a pas de passages trouvés par Sightline ; détectez d’abord les passages.
second-frame-followed = Le véhicule a été suivi pendant son passage.
second-frame-measured = Sa vitesse est celle des points pointés sur deux images.
second-frame-assumed = Le véhicule n’a pu être suivi ; sa vitesse est supposée : cherchez les points autour des repères.
snap-measured-free = Ce véhicule a été tiré au sort pour être mesuré sans propositions.
anchoring-too-few = Trop peu : il faut cinq véhicules de chaque groupe.
proposals-withheld = Les propositions sont masquées pour ce véhicule, tiré au sort pour savoir à quel point elles influencent. Pointez-le vous-même.
proposals-somebody-changed-plan = La part des véhicules aux propositions masquées a changé entre-temps. Contrôlez-la et choisissez à nouveau.
proposals-plan-one-in = Masquez les propositions pour un véhicule sur 2 à { $most }, ou pour aucun (0).
measurements-click-elsewhere = Le contact n’est plus là où Sightline place un tel pointé : la pose de la caméra ou les propositions ont été refaites. Repointez le contact.
snap-no-tyre = Aucun pneu posé sur la chaussée n’a été trouvé à ce pointé ; il reste où il est.
snap-out-of-reach = Le pneu trouvé le plus proche est trop loin de ce pointé ; il reste où il est.
snap-not-sure = Un pneu a été trouvé près de ce pointé, mais pas assez sûrement ; il reste où il est.
measurements-proposals-not-these = Ces points sont périmés : les propositions ont été refaites. Contrôlez-les et confirmez à nouveau.

## Erreurs : caméras

## Hauteurs : pourquoi il n’y en a pas, et ce qu’il faut en savoir ; ce qui est suivi et proposé (conservés par code)

height-click-not-finite = Une coordonnée de pointé n’est pas un nombre fini.
height-contact-outside-picture = Le contact est hors de l’image.
height-target-outside-picture = La cible est hors de l’image.
height-contact-outside-lens = Le contact est hors du rayon de validité du modèle d’objectif ; sa direction est inconnue.
height-target-outside-lens = La cible est hors du rayon de validité du modèle d’objectif ; sa direction est inconnue.
height-camera-below-road = La pose place la caméra sur la chaussée ou dessous ; recalculez la pose de la caméra.
height-contact-above-horizon = Le contact est sur l’horizon ou au-dessus, où il n’y a pas de route.
height-contact-behind-camera = Le contact est derrière le plan de la caméra, vu en travers de la route.
height-plane-edge-on = Le plan latéral passant par le contact est vu presque par la tranche.
height-target-no-crossing = La ligne de visée de la cible ne rencontre pas le plan latéral devant la caméra.
height-target-below-road = La cible est sur la route ou dessous ; contact et cible sont-ils inversés ?
height-u-not-valid = Une incertitude de pointé, un retrait ou son incertitude n’est pas un nombre fini, ou une incertitude est négative.
height-side-unknown = Le côté du conducteur (proche ou éloigné) n’est pas indiqué, et la hauteur de l’œil en dépend ; indiquez-le.
line-height-extrapolated = Un pointé est hors des rangées couvertes par les repères ; la pose est extrapolée.
line-height-click-no-number = Un pointé n’est pas un nombre.
line-height-contact-above-horizon = Le contact est sur l’horizon ou au-dessus, où il n’y a pas de chaussée ; pointez le contact du pneu.
line-height-target-below-contact = La cible n’est pas au-dessus du contact ; pointez d’abord le contact, puis la cible.
line-height-target-behind-camera = Le retrait place la cible derrière la caméra.
line-height-beside-vehicle = Un pointé est hors de l’avant et de l’arrière du véhicule ; il appartient peut-être à un autre.
height-inset-implausible = Le retrait calculé de { NUMBER($inset_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m n’est pas plausible pour un véhicule routier ({ $low_m } à { $high_m } m) : le contact et la cible doivent être les mêmes points sur chaque image.
height-no-board-in-picture = La mire entière n’entre pas dans l’image ; la pose de la caméra ne peut être calculée.
height-picture-too-narrow = L’image ne montre contact et cible que sur { NUMBER($shown_m, minimumFractionDigits: 1, maximumFractionDigits: 1) } m de la trace de roues ; on ne peut les pointer deux fois à { $travel_m } m d’intervalle.
height-frames-too-few = Contact et cible sont nécessaires sur deux images au moins.
height-of-frame = Image { $frame } sur { $frames } : { $reason }
height-travel-short = Le véhicule n’a avancé que de { NUMBER($travel_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m entre les images ; choisissez des images plus éloignées.
height-clicks-disagree = Les pointés ne correspondent pas à un même véhicule en mouvement ; pointez les deux mêmes points sur chaque image.
height-inset-undetermined = Les images ne déterminent pas le retrait ; choisissez des images plus éloignées.
height-no-clicks = Contact et cible ne donnent pas de hauteur.
height-pass-empty = Aucun point n’a été suivi ; confirmez d’abord contact et cible sur une image.
height-pass-not-finite = Un point suivi, son instant ou son incertitude n’est pas un nombre fini.
height-pass-u-not-positive = L’incertitude d’un point suivi n’est pas positive ; indiquez-la en pixels.
height-pass-statement-not-valid = Un temps de pose, une durée de ligne ou une incertitude du suivi est négatif ou trop grand ; corrigez-le.
height-pass-point-twice = Un point est donné deux fois sur une image ; donnez chacun une seule fois.
height-pass-few-frames = Suivi { $point ->
        [contact] du contact
        [second_contact] du second contact
       *[target] de la cible
    } sur { NUMBER($count) } images utilisables seulement ; il en faut { $needed }.
height-pass-short = Suivi { $point ->
        [contact] du contact
        [second_contact] du second contact
       *[target] de la cible
    } sur { NUMBER($travel_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m seulement ; prolongez-le sur plus d’images.
height-pass-no-path = Les points suivis ne donnent pas de trajectoire sur la chaussée ; suivez-les à nouveau.
height-pass-disagrees = Les points suivis ne correspondent pas à un même véhicule en mouvement ; suivez-les à nouveau.
height-pass-inset-undetermined = Les images ne déterminent pas le retrait ; suivez les points sur une plus longue distance.
height-pass-most-excluded = { NUMBER($dropped) } points suivis sur { NUMBER($points) } ont été exclus ; suivez-les à nouveau à partir d’une image plus nette.
height-flag-plane-oblique = Le plan latéral est vu sous moins de 10 degrés.
height-flag-lens-edge = Un pointé est près du bord du rayon de validité du modèle d’objectif.
height-flag-far-from-board = La distance du véhicule est très différente de celle de la mire.
height-flag-u-large = L’intervalle à 95 % est approché : u dépasse 30 mm.
height-flag-no-u-of-lens-and-pose = L’incertitude de l’objectif et de la pose est inconnue et n’est pas comprise.
height-flag-no-u-of-lens = L’incertitude de l’objectif est inconnue ; seul ce qu’indique le fichier de pose est compris.
height-flag-no-board = La mire est inconnue ; son inclinaison, sa hauteur, le côté de ses cases et sa flèche ne sont pas compris dans l’incertitude.
height-flag-no-square-size = La pose n’indique pas le côté des cases de la mire ; non compris dans l’incertitude.
height-flag-no-bow = La pose n’indique pas la flèche de la mire ; non comprise dans l’incertitude.
height-flag-no-square-size-and-bow = La pose n’indique ni le côté des cases ni la flèche de la mire ; non compris dans l’incertitude.
height-flag-clicks-misfit = Les pointés ne suivent pas une trajectoire droite et horizontale ; vérifiez que les mêmes points sont pointés sur chaque image.
height-flag-inset-weak = Les images sont trop rapprochées pour bien déterminer le retrait.
height-flag-pass-misfit = Les points suivis s’écartent d’une trajectoire droite et horizontale de plus que leur incertitude.
height-flag-side-from-place = Le passage n’a pas de sens ; le côté du conducteur se déduit de la position de la caméra sur le terre-plein central, le long duquel tous vont dans le même sens.
height-flag-camera-moved = La caméra a bougé de { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px après le calcul de la pose ; calculez une nouvelle pose pour cette partie, ou décidez de conserver l’ancienne.
height-flag-camera-moved-by = La caméra a bougé de { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px après le calcul de la pose (erreur de hauteur jusqu’à { SMALL($error_m, digits: 0) } sur la route la plus proche dans l’image, davantage au-delà) ; calculez une nouvelle pose pour cette partie, ou décidez de conserver l’ancienne.
height-flag-camera-moved-height = La caméra a bougé de { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px après le calcul de la pose (erreur de hauteur à ces pointés : { SMALL($error_m, digits: 0) }) ; calculez une nouvelle pose pour cette partie, ou décidez de conserver l’ancienne.
height-flag-inset-zero = retrait pris égal à 0
height-flag-u-inset-zero = incertitude du retrait prise égale à 0
height-flag-usual-inset = retrait usuel de { $target }
height-flag-usual-inset-of-side = retrait usuel de { $target }, { $side }
height-target-unknown = La cible { $target } n’est pas l’une de { $known }.
height-side-not-known = Le côté { $side } n’est pas l’un de { $known }.
second-frame-no-height = Il n’y a pas encore de hauteur ; pointez d’abord contact et cible.
second-frame-no-other = Le passage n’a pas d’autre image ; prolongez-le par sa première ou sa dernière image.
second-frame-not-shown = Aucune autre image du passage ne montre les deux points ; utilisez une seule image.
second-frame-no-gain = Une deuxième image n’apporte rien : { SMALL($now_m, digits: 0) } actuellement, { SMALL($then_m, digits: 0) } avec elle.
followed-off = Il est à { NUMBER($off_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px de la position donnée par les autres images, { NUMBER($times, minimumFractionDigits: 1, maximumFractionDigits: 1) } fois son incertitude.
followed-outside-picture = Il est hors de l’image.
followed-outside-lens = Il est hors du rayon de validité du modèle d’objectif.
followed-above-horizon = Il est sur l’horizon ou au-dessus, où il n’y a pas de route.
followed-left-picture = Il est sorti de l’image.
followed-lost = Il a été perdu : rien ne se trouve à l’endroit donné par la vitesse et la pose de la caméra.
followed-elsewhere = Sa position contredit les images voisines.
followed-unlike = L’image diffère trop des autres ici ; il est peut-être caché.
followed-blurred = Il est trop flou ici par rapport aux autres images.
followed-weak = Trop peu de détails sont visibles ici pour le situer à 1,5 px près.
follow-outline = Cette cible est un contour devant un arrière-plan mobile et ne peut pas être suivie ; pointez-la sur deux images.
follow-frame-not-of-pass = Les points confirmés sont sur une image hors du passage.
follow-not-from-here = Le véhicule ne peut pas être suivi à partir de cette image ; confirmez les points sur une autre.
follow-points-needed = Le suivi part d’une image avec le contact et la cible ; pointez les deux sur celle-ci.
contact-wrong-distance = La route est ici trop proche ou trop lointaine pour détecter une roue.
contact-oblique = La roue est vue ici trop en biais ; sa bande de roulement cache le contact.
contact-no-rim = Aucune jante entière n’est visible ici ; le pneu ne peut être séparé de l’ombre et de la carrosserie.
contact-no-edge = Le bord inférieur du pneu ne se détache pas ici de la route.
contact-radius = La roue détectée ici aurait un rayon de { NUMBER($radius_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m.
contact-far-from-pointer = La roue détectée est trop loin du pointeur ; pointez plus près de son contact.
contact-none = Pas de proposition. { $reason } Pointez vous-même le contact.
contact-found = contact proposé, u = { NUMBER($expected_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px
contact-found-rough = contact proposé, u = { NUMBER($expected_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px, moins précis qu’un pointé soigneux
heading-of-contact = { $which ->
    [first] Premier
   *[second] Second
 } contact de pneu : { $reason }
heading-base-short = Les deux contacts de pneu ne sont qu’à { NUMBER($base_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m l’un de l’autre ; pointez le pneu avant et le pneu arrière du même côté.
heading-base-long = Les deux contacts de pneu sont à { NUMBER($base_m, minimumFractionDigits: 0, maximumFractionDigits: 0) } m l’un de l’autre ; pointez les deux pneus d’un même véhicule.
heading-at-edge = Un contact de pneu est au bord de la chaussée visible ; prenez une autre image.
heading-outlier = Exclu comme valeur aberrante ; contrôlez ses pointés.
size-not-measured = Ce n’est pas mesuré.
size-rejected = Sa mesure a été rejetée.
size-no-tyres = Sur aucune image les deux pneus ne sont pointés.
drift-unknown = On ne peut dire si la caméra a bougé : { $reason }
drift-still = Aucun mouvement de la caméra détecté, à { NUMBER($floor_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px près.
drift-still-of-height = Aucun mouvement de la caméra détecté, à { NUMBER($floor_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px près ({ SMALL($floor_m, digits: 1) } de hauteur).
drift-moved = { $how ->
    [bumped] La caméra a bougé
    [before] La caméra avait déjà bougé
   *[drifted] La caméra a dérivé
 } à { $clock } (image { $frame }) de { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px, images { $first } à { $last }.
drift-moved-height = { $how ->
    [bumped] La caméra a bougé
    [before] La caméra avait déjà bougé
   *[drifted] La caméra a dérivé
 } à { $clock } (image { $frame }) de { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px (erreur de hauteur jusqu’à { SMALL($error_m, digits: 0) } sur la route la plus proche dans l’image, différente à d’autres distances), images { $first } à { $last }.
drift-more = { $count ->
    [one] { NUMBER($count) } autre mouvement.
   *[other] { NUMBER($count) } autres mouvements.
  }
drift-near = Les erreurs de hauteur sont celles d’une cible de { $target_m } m de haut, à { $distance_m } m de la caméra, perpendiculairement à la route.
drift-few-points = Seuls { NUMBER($count) } points du fond sont retrouvés, ou tous dans une même partie de l’image ; elle est trop sombre, masquée, ou montre une autre vue.
drift-no-frame = Aucune image n’a été examinée.
drift-no-such-frame = L’enregistrement n’a pas cette image.
drift-nothing-in-pose-frame = L’image de la pose de la caméra n’a rien qui puisse être suivi ; elle est trop sombre ou trop peu contrastée.
drift-recording-of-pose-deleted = La pose de la caméra ne peut pas être comparée à cet enregistrement, car le sien a été supprimé ; calculez une nouvelle pose.
drift-other-size = La taille d’image diffère de celle de la pose de la caméra.
drift-no-target = Aucune cible haute de { $target_m } m sur la route entre 3 et 12 m n’est dans l’image.

cameras-charuco-incomplete = Une mire ChArUco demande le dictionnaire de ses marqueurs, le côté d’un marqueur et le côté d’une case ; indiquez les trois.
cameras-checkerboard-without-markers = Un damier simple n’a pas de marqueurs ; choisissez ChArUco comme type de mire, ou omettez dictionnaire et marqueur.
cameras-frames-outside = Les images { $first } à { $last } ne sont pas dans l’enregistrement ; il a les images 0 à { $frame_count }.
cameras-too-many-views = Une image sur { $every } donnerait { NUMBER($count) } vues ; prenez une image sur { $least } ou moins.
cameras-not-text = { $file_name } n’est pas un fichier texte ; choisissez un étalonnage en YAML, JSON ou cameramodel.
cameras-not-a-file = { $path } n’est pas un fichier ; indiquez des fichiers de photos ou une vidéo.
cameras-still-without-tracks = { $path } est une photo, pas une vidéo à plusieurs pistes ; retirez --stream.
cameras-no-image-size = Choisissez un étalonnage, ou indiquez la largeur et la hauteur de l’image en pixels et son champ horizontal en degrés.
cameras-calibration-other-survey = L’étalonnage { $calibration_id } appartient à un autre relevé ; choisissez-en un des caméras de ce relevé.
cameras-calibration-camera-changed = calibrations.csv : { $id } nomme une autre caméra que les événements d’audit ; le tableau a été modifié.
cameras-taken-without-calibration = La caméra { $camera } n’a pas encore d’étalonnage : il n’y a rien à reprendre ; étalonnez-la dans son propre relevé, ou ajoutez-la ici comme nouvelle caméra.
cameras-taken-from-itself = La caméra { $camera } appartient déjà à ce relevé ; choisissez-en une d’un autre relevé.
cameras-no-name = Une caméra doit avoir un nom ; donnez-lui-en un.
cameras-calibration-other-camera = L’étalonnage { $calibration_id } appartient à une autre caméra ; choisissez-en un de cette caméra.
cameras-image-gone-meanwhile = Une photo a été retirée pendant l’étalonnage ; recommencez-le.
cameras-image-without-reason = Une photo sans mire demande un motif ; indiquez ce qui a été cherché.
commands-baseline-or-rig = Donnez soit --baseline (avec --u-baseline), soit --rig.

## Erreurs : commandes

commands-not-percentile = « { $part } » n’est pas un centile ; indiquez des nombres entre 0 et 100, par exemple --percentile 2.5,10,50.
commands-no-heights = { $path } n’a aucune ligne avec une hauteur ; indiquez un fichier dont des lignes ont le status ok.
commands-heights-without-counts = { $name } a des verdicts mais pas de colonne counts : il n’indique pas quelles hauteurs comptent. Indiquez le heights.csv que `sightline height` produit à partir du clicks.csv du paquet.
commands-not-a-rig = { $path } n’est pas un dispositif : il faut un objet JSON avec baseline_m, comme l’écrit `sightline rig calibrate -o`, et des voies avec chacune son distance_m.
commands-too-large = { $path } dépasse 200 Mo ; indiquez { $what }.
commands-not-exist-give = { $path } n’existe pas ; indiquez { $what }.
commands-not-utf8 = { $path } n’est pas un texte UTF-8 ; indiquez { $what }, enregistré en UTF-8.
commands-cannot-read-give = { $path } est illisible ({ $strerror }) ; indiquez { $what }.
commands-not-json = { $path } n’est pas un JSON lisible ; indiquez { $what }.
commands-not-writable = Impossible d’écrire { $path } ({ $strerror }) ; choisissez un autre emplacement.
commands-stream-camera-missing = La caméra { $name } ne peut pas être ouverte ({ $error }) ; vérifiez son câble, son alimentation et son adresse, et qu’aucun autre programme ne l’utilise.
commands-stream-camera-rows = La caméra { $name } donne des lignes de { $width } pixels, et { $rows } ont été demandés ; indiquez --rows { $width }, ou réglez la caméra.
commands-stream-empty = L’entrée standard s’est terminée avant une première paire de lignes ({ NUMBER($pair_bytes) } octets) ; démarrez d’abord les caméras, et vérifiez --rows.
commands-stream-follow-missing = { $path } est illisible ({ $strerror }) ; indiquez le fichier que le programme des caméras est en train d’écrire.
commands-stream-no-aravis = Les caméras GigE Vision demandent Aravis et PyGObject, absents ici ({ $error }) ; installez gir1.2-aravis-0.8 et python3-gi, ou fournissez les lignes sur l’entrée standard.
commands-stream-no-token = Il faut un jeton : créez-en un dans Compte avec lire, envoyer et mesurer, et mettez-le dans SIGHTLINE_TOKEN.
commands-stream-other-rig = { $path } contient un flux interrompu (segment { $number }), enregistré avec un autre nombre de pixels par ligne ou un autre dispositif ; relancez-le avec les mêmes options pour le reprendre, ou choisissez un autre --spool.
commands-stream-server-needs = --server demande --survey, et --spool pour les lignes jusqu’à ce que le serveur les ait ; donnez les deux.
commands-stream-spool-taken = Un autre flux écrit dans { $path } ; donnez à celui-ci un autre --spool.
commands-stream-two-cameras = Indiquez --camera deux fois, d’abord la caméra que les véhicules atteignent en premier, et sans --follow.
commands-disk-full = Impossible d’écrire { $path } : le disque est plein ; libérez de la place.
commands-charuco-marker-together = --charuco et --marker vont ensemble ; indiquez le dictionnaire et le côté du marqueur.
commands-board-form = --board { $text } n’est pas de la forme 9x6 ; comptez les coins intérieurs en largeur et en hauteur.
commands-size-form = --size { $text } n’est pas de la forme 1920x1080 ; indiquez largeur et hauteur en pixels.
commands-points-missing = Indiquez --contact X,Y et --target X,Y, ou --clicks avec un fichier CSV.
commands-sigmas-not-finite = --sigma, --inset et --u-inset doivent être des nombres finis, --sigma et --u-inset non négatifs ; corrigez-les.
commands-output-missing = Indiquez -o avec le heights.csv à écrire.
commands-point-form = { $option } { $text } n’est pas de la forme X,Y ; indiquez deux nombres de pixels.
commands-problem = { $names } : { $message }
measurements-followed-not-readable = Les points suivis d’une mesure sont illisibles ; ils ont été modifiés.
measurements-followed-and-clicked = Un passage se suit à partir des points d’une seule image ; retirez d’abord les autres images.
measurements-not-followed = Le véhicule ne peut pas être suivi : { $reason }
commands-follow-none = Le véhicule ne peut pas être suivi : { $reason }
commands-tracks-alone = Indiquez soit --tracks, soit --contact et --target, soit --clicks, pas deux d’entre eux.
commands-tracks-point = Ligne { $row } de { $path } : le point { $point } n’est pas l’un de { $points } ; corrigez la cellule.
commands-tracks-frame = Ligne { $row } de { $path } : le numéro d’image n’est pas un nombre entier ; corrigez la cellule.
commands-points-or-clicks = Indiquez soit --contact et --target, soit --clicks, pas les deux.
commands-option-without-effect = --{ $name } est sans effet ici ; utilisez plutôt { $instead }.
commands-output-folder-missing = Impossible d’écrire { $output } : son dossier n’existe pas ; choisissez un autre emplacement.
commands-time-no-offset = { $option } { $text } n’a pas de décalage par rapport à UTC ; écrivez-le avec, comme 2026-05-04T06:00:00.000+02:00.
commands-time-cannot-read = { $option } { $text } n’est pas une heure utilisable ; écrivez-la 2026-05-04T06:00:00.000+02:00.
commands-u-without-start = --u-start demande --start.
commands-idle-without-follow = --until-idle demande --follow.
commands-flow-other-minutes = --interval { $text } est inutilisable ; indiquez une ou plusieurs valeurs parmi 1, 5, 15 et 60, comme 5,60.
commands-flow-not-there = { $place } n’existe pas ; indiquez une archive, des résultats de sightline linescan ou un dossier qui en contient.
commands-flow-folder-empty = { $place } ne contient aucun véhicule balayé ; indiquez une archive, des résultats de sightline linescan ou un dossier qui en contient.
commands-flow-no-start = { $path } n’indique pas quand ses véhicules sont passés (front_at ou start avec un décalage par rapport à UTC) ; refaites-le avec sightline linescan --start.
commands-flow-no-vehicles = { $path } ne contient aucun véhicule ; indiquez le JSON de sightline linescan, qui donne la durée enregistrée.
commands-flow-no-rate = { $path } contient un seul véhicule sans mouvement, dont la cadence de lignes ne se déduit pas ; indiquez le JSON de sightline linescan.
commands-start-u-range = --u-start { $u_s } n’est pas une incertitude-type d’un début ; donnez des secondes entre 0 et 3600.
commands-strip-twice = { $first } est indiqué deux fois ; indiquez les bandes des deux caméras.
backup-none-here = { $folder } ne contient pas de sauvegarde complète (pas de manifest.json) ; relancez sightline backup vers ce dossier, ou nommez-en un autre.
backup-other-format = { $folder } contient une sauvegarde d’un autre format ; utilisez la version de Sightline qui l’a faite.
backup-manifest-damaged = { $path } a été modifié après la sauvegarde ; utilisez une autre sauvegarde.
backup-file-missing = { $name } manque dans la sauvegarde ; utilisez une autre sauvegarde, ou relancez sightline backup vers celle-ci.
backup-file-changed = { $name } de la sauvegarde n’est pas le fichier qui a été sauvegardé ; utilisez une autre sauvegarde.
backup-folder-not-empty = { $folder } contient autre chose qu’une sauvegarde ; choisissez un dossier vide ou une sauvegarde antérieure.
backup-folders-nested = { $folder } et le dossier de données ou de médias sont l’un dans l’autre ; choisissez un dossier ailleurs, de préférence sur un autre disque.
backup-under-way = Une autre sauvegarde est en cours d’écriture dans { $folder } ; attendez la fin.
backup-database-not-copied = La base de données { $path } n’a pas pu être copiée ({ $said }) ; réessayez.
backup-of-another-installation = Le dossier contient une sauvegarde d’une autre installation, ou d’un état postérieur à celui-ci ; choisissez un autre dossier.
backup-other-tables = La sauvegarde a une table { $name } que cette version ne connaît pas ; restaurez-la avec la version qui l’a faite.
backup-rows-misfit = Les lignes de { $name } dans la sauvegarde ne conviennent pas à leur table ; utilisez une autre sauvegarde.
backup-older-crosses-later = La sauvegarde provient d’une version plus ancienne du programme ; restaurez-la dans PostgreSQL, sauvegardez celle-ci avec cette version, puis restaurez ici la nouvelle sauvegarde.
backup-place-not-empty = { $place } n’est pas vide ; restaurez dans un emplacement nouveau ou vide.
backup-database-not-empty = La base PostgreSQL a déjà des tables ; restaurez dans une base vide.
backup-chains-end-elsewhere = Les chaînes d’audit de la base sauvegardée ne finissent pas là où l’indique son manifeste ; utilisez une autre sauvegarde.
backup-chain-broken = La base sauvegardée échoue au contrôle : { $problem }
backup-anchors-of-postgresql = Les chaînes d’audit d’une sauvegarde de PostgreSQL ne sont encore dans aucune base ; restaurez-la et indiquez --head et --checkpoint avec cette base.
backup-damaged-kept = { $problem } Aucune nouvelle sauvegarde n’a été faite ; la dernière bonne, du { $at } UTC, est toujours dans { $folder }.
backup-damaged-none-before = { $problem } Aucune sauvegarde n’a été faite ; { $folder } n’en contient pas d’antérieure, seulement des copies des fichiers médias.
backup-no-earlier = { $folder } ne contient qu’une sauvegarde ; omettez --earlier.
backup-media-missing = { $count ->
    [one] La sauvegarde est complète, mais un fichier média que la base nomme n’est pas dans le stockage des médias : { $names }
   *[other] La sauvegarde est complète, mais { NUMBER($count) } fichiers médias que la base nomme ne sont pas dans le stockage des médias, par exemple { $names }
 } ; cherchez dans une sauvegarde antérieure.

commands-no-database = Aucune base de données dans { $path } ; nommez son dossier avec --data-dir.
commands-cannot-used-correct = { $name } est inutilisable ({ $said }{ $said_2 }) ; corrigez.
commands-camera-or-size = Indiquez soit --camera, soit --size et --field-of-view.
commands-options-without-baseline = --speed, --speed-error, --line-rate et --u-baseline demandent --baseline.
commands-plan-incomplete = Indiquez --camera-height et --distance ; ou --baseline pour un balayage linéaire.
commands-plan-without-speed = Le plan d’un balayage linéaire demande --speed et --speed-error en plus de --baseline.
commands-plan-without-camera = Un balayage linéaire se planifie sans caméra ni emplacement ; omettez ces options.
commands-metrics-port-taken = Les métriques ne peuvent pas être servies sur le port { $port } de { $host } ({ $why }) ; choisissez-en un autre avec SIGHTLINE_METRICS_PORT.
commands-folder-taken = Un autre serveur utilise le dossier { $folder } ; arrêtez-le, ou donnez à celui-ci son propre dossier avec --data-dir.
commands-folder-cannot-written = Impossible d’écrire dans le dossier { $folder } ({ $why }) ; vérifiez ses droits et le disque, ou nommez-en un autre avec --data-dir.
commands-port-taken = Le port { $port } de { $host } est inutilisable ({ $why }) ; choisissez-en un autre avec --port.
commands-option-not-negative = { $option } doit être un nombre fini, non négatif ; corrigez.
commands-row-without-pass = { $path }, ligne { $row } : la cellule pass est vide ; nommez le passage de chaque point.
commands-problem-2 = { $place } : { $problem }
commands-distance-or-speed = Indiquez soit --distance, soit --speed, pas les deux.
commands-grade-without-distance = --grade-difference demande une distance de visibilité ; indiquez aussi --distance ou --speed.
commands-sag-needs-distance = --headlight demande une distance de visibilité ; indiquez aussi --distance ou --speed.
commands-height-or-heights = Indiquez soit --{ $name }, avec son incertitude u si elle est connue, soit --{ $name }-heights avec un fichier.
commands-heights-several-targets = { $path } contient des hauteurs de { $targets } ; indiquez un fichier avec les hauteurs d’une seule cible.
commands-too-few-heights = { $path } : { $reason }. Mesurez-en davantage, ou choisissez un centile plus proche de la médiane.
commands-place-ambiguous = { $place } contient { $names }, qui appartiennent à des choses différentes : l’une pourrait cacher l’autre. Retirez ce qui n’y a pas sa place, et contrôlez-le à part.
commands-place-missing = { $place } n’existe pas ; nommez une base de données, un dossier de données ou un dossier exporté.

## Erreurs : démonstration


## Erreurs : export

export-frame-not-clicked = L’image { $frame } de la vidéo stockée n’est pas celle qui a été pointée.
export-format-not-known = L’archive a le format { $format }, que cette version de Sightline ne connaît pas ; vérifiez-la avec { $program } ou une version ultérieure.
export-made-by-another-version = Faite par la version { $program } ; celle-ci est { $mine }.
export-described-otherwise = datapackage.json énumère chaque fichier avec sa taille et son empreinte ; ses descriptions { $count ->
    [one] de { NUMBER($count) } fichier
   *[other] de { NUMBER($count) } fichiers
  } (et : { $names }) sont celles de cette version-là ; couvertes par le sceau, non comparées.
export-statistics-sealed-only = Les statistiques diffèrent de celles de cette version, car une autre version les a calculées ; couvertes par le sceau, non comparées (première différence : { $difference })
export-drawings-sealed-only = Figures, rapport et README ont été faits par une autre version ; couverts par le sceau, non comparés.
export-page-sealed-only = La page a été faite par une autre version : ses tables ont été comparées ; son programme est couvert par le sceau, non comparé.
export-words-sealed-only = Motifs et remarques ont été mis en mots par une autre version : leurs codes ont été comparés ; les mots sont couverts par le sceau, non comparés.
export-heights-of-another-version = { $count ->
    [one] Un nombre calculé par une autre version diffère
   *[other] { NUMBER($count) } nombres calculés par d’autres versions diffèrent
  } de ce que calcule cette version ; couverts par la chaîne d’audit, non comparés (premier : { $first })
export-statistics-file-added = { $strange } ne découle pas de ces statistiques ; ajouté après coup.
export-crop-added = { $there } n’est dans aucune ligne de crops.csv ; ajouté après coup.
export-crop-points-differ = crops.csv : { $path } a d’autres points ou images que sa mesure ; l’un des deux est faux.
export-crop-hash = { $path } n’est pas celui dont crops.csv contient l’empreinte ; il a été échangé.
export-crop-size = { $path } n’est pas une image de la taille indiquée par crops.csv ; il a été échangé.
export-overlay-points = { $overlay } ne montre pas les points de sa mesure ; il a été modifié.
export-description-unreadable = { $description } est illisible ; reprenez l’export complet.
csv-package-no-code = Une cellule avec un code et ses valeurs ne peut être lue ({ $cell }) ; elle a été modifiée.
export-description-differs = { $description } a une autre valeur de { $name } que les fichiers et la chaîne ; il a été modifié.
export-program-differs = { $description } décrit { $named } autrement que ce programme ; il a été modifié.
export-too-rows-changed = { $path } a { $value ->
    [few] trop peu de lignes
   *[many] trop de lignes
} ; il a été modifié.
export-drawn-file-differs = { $path } n’est pas celui que donnent ces lignes et statistiques ; il a été remplacé.
export-line-differs = { $path }, ligne { $at } : { $name } vaut { $told }, les lignes donnent { $found } ; l’un des deux est faux.
export-crop-missing = { $path } manque ou est nommé deux fois dans crops.csv ; reprenez l’export complet.
export-head-too-short = La tête d’audit est trop courte ({ NUMBER($count) } caractères). Indiquez-en au moins { $least_of_head }.
export-continues-event = La chaîne continue l’événement { NUMBER($event) }, le dernier que garantit ce qui a été indiqué, non les suivants.
export-head-differs = Aucune chaîne d’audit ne passe ici par la tête d’audit indiquée { $head } : elle a été coupée ou réécrite, elle finit avant cette tête, la tête est d’un autre relevé, ou c’est celle d’une base entière, qui change à chaque événement.
export-no-checksums = { $checksums } manque : ce n’est pas un export complet ; exportez à nouveau le relevé.
export-package-is-inside = L’archive est un niveau plus bas, dans { $inner } ; indiquez ce dossier.
export-read-only = { $folder } est en lecture seule. Chaque export est inscrit au journal d’audit ; copiez le dossier sur un disque inscriptible et exportez de là.
export-stray-files = { $count ->
    [one] Le système a ajouté un fichier à ceux de l’archive : { $names }
   *[other] Le système a ajouté { NUMBER($count) } fichiers à ceux de l’archive : { $names }
 }. Supprimez ce qui est nommé ici et relancez le contrôle ; aucun fichier de l’archive n’a encore été examiné.
export-zip-in-zip = { $place } contient { $inner } ; décompressez-le et indiquez celui-là.
export-checksums-no-list = { $checksums } n’est pas une liste d’empreintes : il a été modifié ou coupé après l’export ; reprenez l’export complet.
export-file-renamed = { $path } est ici sous le nom { $there } : des noms de fichiers ont été changés en route ; copiez ou décompressez l’export à nouveau avec ses noms.
export-file-not-listed = { $strange } n’est pas dans SHA256SUMS : il a été ajouté, ou la liste a été modifiée. Retirez ce que vous avez ajouté, ou reprenez l’export complet.
export-file-changed = { $path } a été modifié après l’export ; reprenez l’export complet.
export-checkpoint-form = checkpoint.json n’est pas écrit comme ce programme l’écrit ; reprenez l’export complet.
export-checkpoint-signature = checkpoint.json porte une autre signature que celle que donne sa clé ; il a été modifié.
export-checkpoint-other-chain = checkpoint.json ne garantit pas la fin d’audit.csv ; l’un des deux a été modifié.
export-checkpoint-keys = checkpoint.json ne dit pas comment sa clé découle des précédentes ; il a été modifié.
export-checkpoint-other-key = Signé avec la clé { $key } et non avec la clé indiquée : cela vient d’une autre installation, date d’avant cette clé, ou est falsifié.
export-key-too-short = La clé est trop courte. Indiquez au moins ses { $least } premiers caractères.
export-no-seal = audit.csv ne finit pas par l’événement qui scelle l’archive : il a été tronqué ou modifié ; reprenez l’export complet.
export-page-not-described = { $path } n’est pas décrit par datapackage.json, ou manque bien qu’il le soit ; reprenez l’export complet.
export-page-another-program = { $path } n’est pas la page que nomme datapackage.json ; reprenez l’export complet.
export-page-carries-another = La page porte un autre { $path } que l’archive ; reprenez l’export complet.
export-seal-differs = { $path } n’est pas ce que dit le sceau de l’archive, dernier événement d’audit.csv : il a été modifié, retiré ou ajouté après l’export, et les sommes avec lui.
export-event-of-other = audit.csv : l’événement { $number } est donné ou omis là où le sceau de l’archive dit le contraire, ou la chaîne ne commence pas par le relevé ; audit.csv a été modifié après l’export.

## Erreurs : géométrie

geometry-too-few-pictures = Photos utilisables : { $used } sur { $given }, il en faut au moins { $least } ; prenez d’autres photos de la mire entière, sous des angles différents.
geometry-too-few-images = Photos utilisables : { $used } sur { $given }, il en faut au moins { $least } ; prenez d’autres photos de la mire entière, sous des angles différents. { $file } : { $reason }
geometry-board-corner-count = Une mire de { $columns }x{ $rows } coins intérieurs est inutilisable ; comptez les coins intérieurs (où quatre cases se touchent), de 3 à 60 dans chaque direction.
geometry-square-implausible = Une case de { $square_m } m n’est pas plausible ; indiquez le côté d’une case en mètres.
geometry-model-misfit = Le modèle { $model } n’a pas pu être ajusté à ces vues ; ajoutez des vues de différents côtés ou utilisez l’autre modèle.
geometry-size-not-calibrated = { $what } fait { $width_px }x{ $height_px } px, mais la caméra a été étalonnée à { $width_px_2 }x{ $height_px_2 } px ; utilisez un étalonnage fait à la taille de l’enregistrement.
geometry-dictionary-unknown = { $dictionary } n’est pas un dictionnaire de marqueurs ; c’est l’un de { $dictionaries }, selon les indications du fabricant de la mire.
geometry-markers-over-squares = Des marqueurs de { $marker_m } m ne vont pas avec des cases de { $square_m } m ; indiquez le côté du marqueur noir, plus petit que sa case.
geometry-board-marker-count = Une mire de { $columns }x{ $rows } coins intérieurs a { $needed } marqueurs et { $dictionary } en contient { $held } ; choisissez le dictionnaire avec lequel la mire a été faite.
adjustment-nothing-uncertain = la pose n’indique aucune incertitude propre ni de mire : le trafic ne peut donc rien y changer ; créez-la avec sightline pose.
adjustment-contradictory = passages en contradiction avec les autres : { NUMBER($out) } sur { NUMBER($passes) } ; vérifiez les longueurs connues, leurs incertitudes et les points suivis.
adjustment-does-not-settle = les passages ne convergent pas vers une seule pose ; vérifiez que chaque point suit le même endroit de son véhicule.
geometry-key-wrong = { $what } : « { $key } » doit être { $wanted } ; corrigez cette clé ou refaites le fichier.
geometry-format-is-another = { $what } est au format { $found }, alors qu’il faut { $wanted } ; donnez un fichier de ce format.
geometry-not-an-object = { $what } doit être un objet JSON ; écrivez-le avec sightline ou voyez docs/formats.md.
geometry-distortion-unsupported = { $file_name } : le modèle de distorsion « { $word } » n’est pas pris en charge ; plumb_bob, rational_polynomial, radtan, equidistant et fisheye le sont.
geometry-file-too-large = { $file_name } est trop volumineux pour un fichier d’étalonnage ; choisissez le fichier qui contient les paramètres intrinsèques.
geometry-opencv-xml = { $file_name } est du XML d’OpenCV, que Sightline ne lit pas ; enregistrez-le à nouveau depuis OpenCV sous un nom finissant par .yml (FileStorage écrit alors du YAML).
geometry-states-no-distortion = { $file_name } n’indique pas la distorsion de l’objectif ; ajoutez distortion_coefficients, ou cinq zéros si l’objectif n’en a pas.
geometry-no-camera = { $file_name } ne contient pas de caméra ; indiquez un YAML ou JSON OpenCV, un camera_info ROS, un camchain Kalibr ou un .cameramodel mrcal.
geometry-values-not-finite = { $file_name } : { $what } contient des valeurs non finies ou trop grandes ; refaites l’étalonnage.
geometry-size-not-whole = { $file_name } : la taille d’image doit comporter deux nombres entiers de pixels.
geometry-no-matrix = { $file_name } ne contient pas de matrice de caméra (camera_matrix ou K) ; exportez les paramètres intrinsèques avec leurs coefficients de distorsion.
geometry-matrix-form = { $file_name } : la matrice de caméra doit être de 3x3, avec 0 0 1 comme dernière ligne.
geometry-matrix-skew = { $file_name } : la matrice de caméra a une obliquité, non prise en charge ; étalonnez sans elle.
geometry-camera-not-named = { $file_name } ne contient pas de caméra « { $which } » ; il contient { $cameras }.
geometry-key-written-twice = { $file_name } contient deux fois la clé « { $key } » ; ne laissez que celle qui vaut.
geometry-rows-contradict = { $file_name } : { $what } annonce { $rows } lignes et { $columns } colonnes mais contient { NUMBER($count) } nombres ; exportez à nouveau le fichier.
geometry-camera-not-calibrated = { $file_name } : la matrice de la caméra ne contient que des 0, ce par quoi un pilote indique que la caméra n’est pas étalonnée ; étalonnez-la d’abord.
geometry-roi-contradicts-size = { $file_name } : la partie de l’image (roi) ne tient pas dans la taille de l’image ; indiquez le camera_info d’images entières.
geometry-focal-implausible = { $file_name } : une distance focale de { $focal } n’est pas plausible pour des images larges de { $width } px ; elle doit être en pixels.
geometry-lens-turns-back = { $file_name } : avec ces coefficients de distorsion, l’objectif se replie près du milieu de l’image ; vérifiez leur ordre et le modèle d’objectif.
geometry-model-unsupported = { $file_name } : le modèle de caméra « { $camera_model } » n’est pas pris en charge ; étalonnez en sténopé.
geometry-intrinsics-count = { $file_name } : intrinsics doit contenir quatre nombres, fu fv pu pv.
geometry-lens-unsupported = { $file_name } : le modèle d’objectif { $word } n’est pas pris en charge ; convertissez-le avec mrcal-convert-lensmodel en LENSMODEL_OPENCV8.
geometry-needs-intrinsics-file = { $file_name } : { $word } demande { $value } paramètres intrinsèques, le fichier en a { NUMBER($count) }.
geometry-no-image-size = { $file_name } n’indique pas la taille des images ; ajoutez-y image_width et image_height.
geometry-focal-not-positive = { $file_name } : les focales doivent être des nombres positifs de pixels.
geometry-principal-point-outside = { $file_name } : le point principal est très en dehors de l’image ; corrigez la taille d’image.
geometry-thin-prism = { $file_name } : les coefficients de prisme mince et d’inclinaison ne sont pas pris en charge ; étalonnez avec huit au plus.
geometry-distortion-count = { $file_name } : { NUMBER($count) } coefficients de distorsion ; 4, 5 ou 8 sont pris en charge.
geometry-camera-unreadable = { $file_name } n’est pas un fichier de caméra lisible ; indiquez un YAML ou JSON OpenCV, un camera_info ROS, un camchain Kalibr ou un .cameramodel mrcal.
geometry-not-numbers = { $file_name } : { $what } n’est pas une liste de nombres ; exportez à nouveau le fichier.
geometry-size-not-two = { $file_name } : la taille d’image doit comporter deux nombres, largeur et hauteur.
geometry-camera-info-binned = { $file_name } : { $key } vaut { $data } ; indiquez le camera_info d’images sans regroupement de pixels.
geometry-fisheye-count = { $file_name } : un modèle fisheye demande quatre coefficients, le fichier en a { NUMBER($count) }.
geometry-board-not-found = La mire n’a été trouvée dans aucune des { NUMBER($count) } images. { $reason }
geometry-pose-misfit = Aucune pose ne convient aux coins ; vérifiez que le fichier de caméra est celui de cet enregistrement et que toute la mire est dans le rayon de validité de l’objectif.
geometry-heights-not-numbers = La hauteur de référence et les incertitudes de la mire doivent être des nombres, en mètres et radians, les incertitudes non négatives.
geometry-row-height-implausible = Une rangée de référence à { $height_m } m au-dessus de la chaussée n’est pas plausible ; indiquez en mètres la hauteur au-dessus de la chaussée de la rangée de coins intérieurs « { $side } ».
geometry-board-moves = La mire ou la caméra bouge pendant ces images (jusqu’à { NUMBER($moved_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px) ; choisissez une plage, ou une seule image, où toutes deux sont immobiles.
geometry-corners-misfit = Les coins ne conviennent pas au modèle de caméra (résidu { NUMBER($rms, minimumFractionDigits: 1, maximumFractionDigits: 1) } px) ; le fichier est d’une autre caméra ou d’un autre zoom, ou la mire est courbée.
geometry-board-edge-on = La mire est vue par la tranche ; tournez-la vers la caméra, d’au moins 10 degrés.
geometry-board-lies-flat = La mire semble posée à plat sur la chaussée ; dressez-la à angle droit avec la chaussée, rangées horizontales, ou mesurez la hauteur de la rangée de coins que vous avez nommée.
geometry-camera-below-road = La hauteur de référence de { $height_m } m place la caméra sous la chaussée ; indiquez en mètres la hauteur au-dessus de la chaussée de la rangée de coins intérieurs « { $side } ».
geometry-image-range = Une image de { $width_px } x { $height_px } px est hors plage ; indiquez une largeur et une hauteur de 16 à 16384.
geometry-view-range = Un champ horizontal de { $degrees } degrés est hors plage ; indiquez une valeur de 5 à 150.
geometry-plan-range = { $what } : { $value } { $unit } est hors plage ; indiquez une valeur de { $least } à { $most }.

## Erreurs : audit

audit-signing-key-unreadable = { $path } ne contient pas de clé de signature (64 chiffres hexadécimaux) ; rétablissez-la depuis une sauvegarde.
audit-signing-key-another = La clé de signature de cette machine n’est pas celle qui a signé la base de données ; si un changement de clé a été interrompu, lancez `sightline checkpoint`, sinon rétablissez signing.key depuis une sauvegarde, ou donnez à toutes les machines le même SIGHTLINE_SIGNING_KEY.
audit-other-version = Cette base de données a été faite par une autre version ; contrôlez-la avec celle-là, ou ouvrez-la une fois avec celle-ci (`sightline serve`), qui la met à jour.
audit-guard-missing = La base de données ne protège plus { $table } : un déclencheur qui refuse les modifications manque ou est désactivé. Restaurez une sauvegarde, ou rétablissez le déclencheur et cherchez qui l’a retiré.
audit-not-a-database = { $name } n’est pas une base de données de Sightline, ou son début est endommagé ; nommez le fichier sightline.db d’un dossier de données, ou restaurez une sauvegarde.

## Erreurs : csv_package

csv_package-event-not-next = audit.csv : l’événement { $number } ne découle pas du précédent ; il a été modifié.
csv_package-event-not-hashed = audit.csv : l’événement { $number } n’est pas celui qui a été haché ; il a été modifié.
csv_package-file-missing = { $path } manque ; reprenez l’export complet.
csv_package-target-is-file = { $target } est un fichier ; nommez pour l’export un dossier qui n’existe pas encore.
csv_package-target-not-empty = { $target } contient d’autres fichiers ; nommez un dossier vide ou qui n’existe pas encore.
csv_package-file-twice = { $place } contient un fichier deux fois, ce n’est donc pas un export ; reprenez l’export.
csv_package-table-twice = { $path } est deux fois dans l’archive, on ne peut donc savoir lequel fait foi ; reprenez l’export complet.
csv_package-not-an-export = { $place } ne peut pas être lu comme un export ; nommez son dossier ou son ZIP.
csv_package-parquet-not-paired = { $path } est là sans son autre forme : chaque tableau d’une archive existe en CSV et en Parquet ; reprenez l’export complet.
csv_package-parquet-described-otherwise = { $path } a d’autres colonnes, unités ou significations que ne le décrit datapackage.json ; il a été modifié.
csv_package-parquet-not-csv = { $path } n’est pas ce que contient { $csv_path } : la colonne { $name } diffère à la ligne { $at } ; l’un des deux a été modifié.
csv_package-parquet-other-rows = { $path } n’a pas les lignes de { $csv_path } ; l’un des deux a été modifié.
csv_package-parquet-unreadable = { $path } ne peut pas être lu comme Parquet ; reprenez l’export complet.
csv_package-cell-type = { $path } a une cellule qui n’est pas du type que datapackage.json donne à sa colonne ; il a été modifié.
csv_package-csv-form = { $path } n’est pas écrit comme Sightline écrit un tableau (vers la ligne { $at } : autre fin de ligne, autre guillemet) : des programmes pourraient y lire des choses différentes ; reprenez l’export complet.
csv_package-zip-odd-entry = { $place } contient { $path }, qui n’est pas un simple fichier d’une archive ; reprenez l’export complet.
csv_package-zip-bomb = { $place } : { $path } se décompresserait en bien plus que ne contient un tableau ; reprenez l’export complet.
csv_package-too-many-files = { $place } énumère plus de fichiers qu’une archive ne peut en avoir ; reprenez l’export complet.
csv_package-link = { $path } est un lien, non un fichier (ou un tube ou périphérique) : un export n’en a pas ; reprenez l’export complet.
csv_package-no-json = { $path } ne peut pas être lu comme JSON : il a été coupé ou modifié après l’export ; reprenez l’export complet.
csv_package-zip-encrypted = { $place } est protégé par un mot de passe ; décompressez-le avec le mot de passe et indiquez le dossier.
csv_package-json-form = { $path } n’est pas écrit comme Sightline écrit du JSON (une clé en double, d’autres espaces ou nombres) : des programmes pourraient y lire des choses différentes ; reprenez l’export complet.
csv_package-columns-differ = { $path } a d’autres colonnes que celles que décrit datapackage.json ({ $column }) : il a été modifié après l’export.
csv_package-not-csv = { $path } ne peut pas être lu comme CSV ; reprenez l’export complet.
csv_package-not-unpackable = { $path } ne peut pas être décompressé ; reprenez l’export complet.
csv_package-not-as-described = { $path } ne peut pas être lu tel qu’il a été décrit ; reprenez l’export complet.
csv_package-row-length = { $path } a une ligne trop longue ou trop courte ; il a été modifié.
csv_package-without-event = { $path } : { $kind_name } { $odd } est là sans événement d’audit, ou manque.
csv_package-twice-one-put = { $path } : { $columns } { $values } est là deux fois ; ajout après coup.
csv_package-event-differs = { $path } diffère de son événement d’audit ; il a été modifié.
csv_package-chain-file-changed = { $path_of } n’est pas celui que garantit la chaîne d’audit ; il a été modifié.
csv_package-author-or-time = { $path } : { $kind_name } { $id } a un autre auteur ou une autre date que ne le dit { $path_2 }.
csv_package-differs-one-changed = { $path } : { $kind_name } { $id } diffère de { $path_2 } ; l’un des deux a été modifié.
csv_package-row-without-event = { $path } : la ligne { $key } n’a pas d’événement d’audit ; elle a été ajoutée.
csv_package-row-differs = { $path } : { $name } de la ligne { $key } diffère de ses événements d’audit ; la valeur a été modifiée.
csv_package-row-missing = { $path } : la ligne { $key } manque, bien qu’un événement d’audit en parle.
csv_package-row-dangling = { $path } : { $mine } { $values } n’est pas dans { $table }.csv ; une ligne a été retirée ou modifiée.

## Erreurs : base de données

database-not-supported = Une base de données { $backend } n’est pas prise en charge ; utilisez sqlite:///FILE ou postgresql+psycopg://USER@HOST/NAME.
database-no-answer = La base de données ne répond pas ; vérifiez qu’elle est en marche et que son adresse est juste.
database-in-memory = Une base en mémoire serait perdue ; nommez un fichier, comme dans sqlite:///sightline.db.
database-disk-full = Le disque est plein, rien n’a été enregistré ; libérez de la place et réessayez.
database-busy = La base de données est occupée par une autre écriture ; réessayez dans un instant.
database-not-writable = Le fichier de la base de données ne peut pas être ouvert en écriture ; vérifiez les droits du dossier.
database-address-unreadable = L’adresse de la base de données est illisible ; utilisez sqlite:///FILE ou postgresql+psycopg://.
database-missing = Il n’y a pas de base de données { $path } ; vérifiez son nom.
database-not-a-database = Ce fichier n’est pas une base de données de Sightline, ou son début est endommagé ; indiquez le bon fichier, ou restaurez une sauvegarde.
database-damaged = La base de données est endommagée : des parties de son fichier contiennent autre chose. Arrêtez le serveur, gardez une copie du dossier de données et restaurez la dernière sauvegarde (sightline restore).
database-read-only-log = { $path } est en lecture seule, et ses derniers changements sont encore dans le fichier voisin qui finit par -wal ; copiez le dossier sur un disque inscriptible et indiquez celui-là.
database-damaged-tables = La base de données est endommagée dans { $tables } ; ses { $whole } autres tables sont lisibles. Arrêtez le serveur, gardez une copie du dossier de données et restaurez la dernière sauvegarde (sightline restore).
database-account-lacks-rights = Il manque au compte de la base de données un droit nécessaire ici ; exécutez `sightline migrate` avec le compte qui possède les tables.
database-no-migrations = Il n’y a pas de migrations dans { $folder } ; réglez SIGHTLINE_MIGRATIONS sur le dossier qui les contient.
database-newer-version = La base de données a été faite par une version plus récente ; mettez celle-ci à jour avant de l’ouvrir.
database-row-missing = Introuvable : { $word ->
    [survey] relevé
    [person] personne
    [study] étude
    [vehicle] véhicule
    [measurement] mesure
    [upload] envoi
    [export] export
    [member] membre
    [lot] lot
    [recording] enregistrement
    [calibration] étalonnage
    [photograph] photo
    [computing] recalcul
    [camera] caméra
    [job] tâche
    [result] résultat
    [token] jeton
   *[other] { $word }
}{ $number } ; peut-être supprimé entre-temps : revenez en arrière et faites un autre choix.

## Erreurs : tâches

jobs-not-yours = Quelqu’un d’autre a lancé cette tâche ; demandez-lui, ou à un opérateur, de l’annuler.
jobs-not-to-be-cancelled = Cette tâche supprime des fichiers devenus inutiles et ne s’annule pas ; laissez-la se terminer.
jobs-kind-unknown = Ce processus ne connaît pas de tâche du type { $kind_name } ; lancez-en un de cette version.
jobs-other-worker = La tâche { $id } est passée à un autre processus ; celui-ci s’arrête.
jobs-already-over = La tâche { $job_id } est déjà dans l’état { $state ->
    [done] terminé
    [failed] échec
    [cancelled] annulé
   *[other] { $state }
} ; il n’y a rien à annuler.
jobs-changed-meanwhile = L’état de la tâche { $id } a changé entre-temps ; il n’y a rien à faire.
jobs-given-away = La tâche { $id } a été confiée à un autre processus ; celui-ci s’arrête.

## Erreurs : web

web-disk-not-writable = Le dossier des données ne peut pas être écrit ({ $why }) ; vérifiez le disque et ses droits.
web-part-silent = Pas de réponse depuis { $seconds } s ; vérifiez que ce service est en marche et joignable.
web-writer-stuck = Une modification est en cours depuis { $seconds } s et bloque les autres ; vérifiez la base de données.
web-secret-weak = SIGHTLINE_SECRET peut être deviné ; utilisez au moins { $characters } caractères aléatoires qui ne sont publiés nulle part (openssl rand -hex 32).
web-signing-key-missing = SIGHTLINE_SIGNING_KEY n’est pas défini, chaque machine signerait donc avec sa propre clé ; donnez à toutes les mêmes 64 chiffres hexadécimaux (openssl rand -hex 32).
infra-setting-differs = { $name } diffère de la valeur des autres processus sur cette base de données ; donnez à tous la même, ou arrêtez d’abord les autres.
infra-clocks-apart = L’horloge de cette machine et celle de la base de données diffèrent de { $minutes } minutes ; synchronisez-les avec un serveur de temps (NTP) et redémarrez.
web-server-busy = Le serveur est occupé et rien n’a été fait ; réessayez dans quelques secondes.
web-not-signed-in = Vous n’êtes pas connecté ; connectez-vous et réessayez.
web-token-invalid = Ce jeton n’est pas valable : il est erroné, expiré ou révoqué ; créez-en un nouveau dans Compte.
web-token-lacks-scope = Ce jeton permet { $scopes }, et ceci demande { $needed } ; créez un jeton avec ce droit dans Compte.
web-token-never = Aucun jeton ne permet ceci ; connectez-vous dans le navigateur et faites-le là.
web-token-requests-many = Plus de { NUMBER($most) } requêtes en une minute avec ce jeton ; attendez une minute et continuez.
members-last-manager = Un relevé doit avoir un gestionnaire ; nommez-en d’abord un autre.
audit-checkpoint-none = Ce point de contrôle n’existe pas : choisissez-en un dans la liste de la page Système.
web-needs-role = Il faut pour cela le rôle { $needed ->
    [viewer] lecteur
    [operator] opérateur
    [reviewer] vérificateur
    [manager] gestionnaire
    [admin] administrateur
   *[other] { $needed }
}, et vous avez le rôle { $role ->
    [viewer] lecteur
    [operator] opérateur
    [reviewer] vérificateur
    [manager] gestionnaire
    [admin] administrateur
   *[other] { $role }
} ; demandez-le à un administrateur.
web-too-large = { $name } dépasse { $most_bytes } Mo ; réduisez-le et réessayez.

## Erreurs : linescan

linescan-strips-too-low = Les bandes ont { $rows } rangées de haut ; il en faut au moins 8 pour trouver un véhicule.
linescan-strips-differ = Les bandes diffèrent : { $shape } et { $shape_2 } lignes par rangées, { $rows } rangées attendues ; les deux caméras doivent enregistrer les mêmes lignes.
linescan-cannot-used-give = { $name } de { $value } { $unit } est inutilisable ; indiquez de { $least } à { $most } { $unit }.
line-pose-mark-incomplete = Chaque repère a besoin d’une distance, d’une hauteur et d’une rangée.
line-pose-not-numbers = Les distances, hauteurs et rangées des repères doivent être des nombres.
line-pose-too-few = { NUMBER($count) } repères ne suffisent pas ; pointez-en au moins { $least }.
line-pose-above-zero = Les distances des repères et la u de leurs rangées doivent être supérieures à 0.
line-pose-upside-down = Les repères les plus hauts doivent avoir les rangées les plus petites ; contrôlez le sens du jalon.
line-pose-open = Les repères ne déterminent pas la hauteur de la caméra : tenez le jalon vertical à deux distances, par exemple aux bords proche et éloigné de la voie.
line-pose-below-road = Les repères placent la caméra sous la route ; contrôlez leurs distances, hauteurs et rangées.
line-pose-one-distance = Tous les repères sont à une même distance : la hauteur de la caméra ne peut être déterminée ; tenez le jalon vertical à deux distances.
line-pose-wide = Les repères ne suivent le modèle qu’à { $rms_px } px près, moins bien que des pointés de { $sigma_px } px ne l’expliquent ; contrôlez les distances et le repère au plus grand résidu.
line-pose-vague = La hauteur de la caméra n’est connue qu’à { $u_height } m ; tenez le jalon à deux distances plus éloignées, ou mesurez-les mieux.
rig-pass-no-way = Il n’a ni positions ni lignes ; donnez les valeurs d’une méthode.
rig-pass-two-ways = Il a des valeurs de deux méthodes ({ $one } et { $two }) ; donnez à chacune sa propre ligne.
rig-pass-lacks = La valeur { $column } manque ; indiquez-la.
rig-pass-no-rate = Sa vitesse demande la cadence de lignes des caméras ; indiquez-la.
rig-pass-no-order = Les lignes du panneau ne sont pas dans l’ordre : son avant passe devant chaque caméra avant son arrière, et les deux caméras voient d’abord le même bord.
rig-pass-stopped = Le panneau s’est arrêté ou presque entre les plans ; passez-le d’un mouvement régulier.
rig-pass-span = Il donne une base de { $span_m } m, hors de la plage de { $least } à { $most } m ; corrigez ses valeurs.
rig-pass-value = La valeur { $column } est hors plage : { $value } ; corrigez-la.
rig-passes-differ = Les passages diffèrent plus que leurs incertitudes ne l’expliquent (p = { $chance } %) ; contrôlez d’abord le passage { $name }.
rig-passes-too-wide = Les passages concordent mieux que leurs incertitudes indiquées ; celles-ci sont peut-être trop grandes.
rig-passes-two-distances = Deux distances ne permettent pas de vérifier que la base varie linéairement ; ajoutez-en une troisième.
rig-passes-outside = { NUMBER($distance_m, minimumFractionDigits: 2) } m est loin des passages ({ NUMBER($nearest_m, minimumFractionDigits: 2) } à { NUMBER($farthest_m, minimumFractionDigits: 2) } m) : la base y est extrapolée ; ajoutez un passage à cette distance.
rig-pass-twice = Une autre ligne a le même nom ; nommez chaque passage une fois.
linescan-rig-pass = Passage { $name } : { $sentence }
linescan-rig-common = Les incertitudes de la cadence de lignes, du mètre ruban et de la vitesse sont des parts de 0 à 0,1 (1e-4 vaut 0,01 %) ; corrigez-les.
linescan-lane-needs-name = Une voie n’a pas de nom ; donnez-lui-en un.
linescan-lanes-same-name = Deux voies s’appellent { $name }, ou un nom commence ou finit par une espace ; donnez à chacune son nom.
linescan-lane-rows-both = La voie { $name } n’a qu’une rangée pour ses pneus ; donnez les deux, ou aucune.
linescan-lane-rows-order = Les rangées de la voie { $name } ne sont pas en ordre ; donnez d’abord la plus haute, 0 ou plus.
linescan-divergence-without-distance = Une divergence exige la distance aux véhicules ; indiquez-la, ou omettez la divergence et son incertitude.
linescan-planes-cross = Avec cette divergence, les plans de balayage se croisent devant les véhicules, qui sont à { $distance_m } m ; corrigez la base, la divergence ou la distance.
linescan-planes-too-near = Avec cette divergence, les plans de balayage sont distants de { $baseline_m } m à { $distance_m } m ; il faut au moins { $least_m } m.
linescan-rig-few-passes = { NUMBER($count) } passages utilisables ne suffisent pas pour la base et la divergence ; il en faut au moins { $least }, à deux distances ou plus.
linescan-rig-distances-alike = Tous les passages sont entre { $nearest_m } et { $farthest_m } m, trop proches pour séparer la base de la divergence ; ajoutez des passages à une autre distance, comme la voie proche et la voie éloignée.
linescan-width-two-u = Le panneau de { $width_m } m a deux incertitudes de largeur différentes ; donnez la même à chaque ligne.
linescan-distance-two-u = La distance de { $distance_m } m a deux incertitudes différentes ; donnez la même à chaque ligne de cette position.
linescan-rig-contradict = Les passages se contredisent (khi-deux { $chi2 } pour { $degrees ->
    [one] { NUMBER($degrees) } degré
   *[other] { NUMBER($degrees) } degrés
 } de liberté) : le passage { $name } s’écarte des autres de { $residual_mm } mm là où { $expected_mm } mm (U95) étaient attendus. Mesurez-le à nouveau, écartez-le, ou donnez des incertitudes plus grandes.
rig-passes-too-many = { $name } a plus de { $most } lignes ; donnez les seuls passages d’un étalonnage.
rig-passes-columns = Il manque des colonnes à { $name } ; donnez distance_m et toutes les colonnes d’une même méthode : { $ways }.
rig-passes-problem = { $path } : { $message }{ $left }
rig-no-lane = --distance { $text } n’est pas une distance à la voie ; donnez-la en mètres et, après une virgule, son u, comme 4.2 ou 4.2,0.1.
commands-option-above-zero = { $option } doit être un nombre fini supérieur à 0 ; corrigez-le.

## Erreurs : mesures

measurements-vehicle-other-recording = Le véhicule n’appartient pas à cet enregistrement ; choisissez l’un de ses passages.
measurements-frame-twice = L’image { $twice } est pointée deux fois ; pointez les deux points sur une autre image du passage.
measurements-point-outside = Le point « { $word } » { $point }, { $point_2 } n’est dans aucune image ; repointez.
measurements-no-pose = { $name } n’a pas encore de pose de la caméra ; calculez-en ou choisissez-en une d’abord sur la page Route.
measurements-pose-image-size = La pose de la caméra de { $name } vaut pour des images de { $size_px } x { $size_px_2 } px, non pour sa taille ; calculez-en ou choisissez-en une autre sur la page Route.
measurements-frame-cannot-split = L’image { $frame } ne peut pas scinder le véhicule { $number } ; allez à une image après sa première ({ $first_frame }) et jusqu’à sa dernière ({ $last_frame }).
measurements-join-other-recording = Seuls deux passages du même enregistrement peuvent être fusionnés ; choisissez-en un autre.
measurements-join-both-measured = Les véhicules { $number } et { $number_2 } ont tous deux des mesures, et une mesure reste avec son véhicule ; écartez plutôt l’un des passages.
measurements-split-between = Le véhicule { $number } a été mesuré avant et après l’image { $frame }, et une mesure reste avec son véhicule ; scindez-le à une autre image.
measurements-withdrawn = Cette mesure est retirée ; restaurez-la avant de la modifier.
measurements-repeat-fixed = Une répétition ne peut pas être modifiée ; retirez-la et repointez.
measurements-withdrawn-already = Cette mesure est déjà retirée ; restaurez-la pour l’utiliser à nouveau.
adjusting-changed-meanwhile = L’ajustement a changé depuis son affichage ; contrôlez-le à nouveau.
adjusting-nothing-in-force = Ce n’est pas une pose ajustée en vigueur : il n’y a rien à annuler.
computing-undo-of-undo = Une annulation ne s’annule pas ; recalculez plutôt les hauteurs.
computing-undone-already = Ceci a déjà été annulé ; recalculez les hauteurs pour les retrouver.
computing-undo-later-first = Les hauteurs ont été recalculées le { $when } ; annulez d’abord ce calcul.
computing-revision-count = computings.csv : { $id } a fait un autre nombre de révisions qu’il ne dit ; reprenez l’export complet.
computing-mark-wrong = { $path } : la marque « périmé » de { $id } ne découle pas de ses données ; reprenez l’export complet.
computing-verdict-went-over = revisions.csv : la révision { $revision } de la mesure { $name } a une décision rendue sur une autre hauteur ; reprenez l’export complet.
measurements-not-withdrawn = Cette mesure n’est pas retirée : il n’y a rien à restaurer.
measurements-vehicle-deleted = { $name } a supprimé le véhicule { $vehicle_number } le { $when } ; restaurez-le d’abord.
measurements-changed-meanwhile = { $name } a modifié cette mesure le { $created_at } UTC ; rechargez-la.
measurements-repeat-mismatch = Une répétition demande le véhicule et la cible de la mesure qu’elle répète.
measurements-pose-other-survey = La pose { $pose_id } de la caméra appartient à un autre relevé ; choisissez-en une de ce relevé.
measurements-empty-without-reason = Une mesure sans hauteur demande un motif ; recalculez-la.
measurements-no-height-reason = Une mesure qui n’a pas de hauteur demande un motif ; recalculez-la.
measurements-other-vehicle = Cette mesure a déjà été enregistrée pour un autre véhicule ; repointez.
measurements-frame-not-clicked = L’image { $frame } n’est pas celle qui a été pointée ; rechargez-la.
measurements-status-differs = { $name } indique { $status }, ses pointés donnent { $status_2 } ; l’un des deux est faux.
measurements-words-differ = { $name } : { $column } ne dit pas ce que dit le code à côté ; l’un des deux a été modifié.
measurements-revision-without-event = { $path } : la mesure { $key } n’a pas d’événement d’audit pour la révision { $key_2 } ; ajout après coup.
measurements-event-differs = { $path } : la mesure { $key } diffère de son événement d’audit ; elle a été modifiée.
measurements-drift-differs = { $name } : le dernier avertissement n’est pas ce que donnent le mouvement de la caméra et les pointés : { $computed }
measurements-no-revisions = revisions.csv : la mesure { $id } n’a pas de révision ; une a été retirée.
measurements-pose-missing = { $path } manque ou n’est pas une pose de la caméra ; reprenez l’export complet.
measurements-result-differs = { $name } indique { $words } { $told }, ses pointés donnent { $computed } ; l’un des deux est faux.
measurements-last-revision-differs = measurements.csv : { $id } a une autre valeur de { $column } que sa dernière révision.
measurements-value-differs = { $path } : { $id } a une autre valeur de { $name } que measurements.csv ; l’un des deux est faux.
measurements-operator-differs = measurements.csv : l’opérateur de { $id } n’est pas l’auteur de la première révision avec ses points (revisions.csv) ; l’un des deux est faux.
measurements-clicked-at-differs = measurements.csv : clicked_at de { $id } n’est pas le moment de la première révision avec ses points (revisions.csv) ; l’un des deux est faux.
measurements-vehicle-differs = { $path } : { $id } a une autre valeur de { $name } que son véhicule dans vehicles.csv ; l’un des deux est faux.
measurements-vehicle-missing = { $path } : le véhicule de { $id } n’est pas dans vehicles.csv ; une ligne a été supprimée.
measurements-row-misplaced = { $path } : { $name } n’est pas à sa place ; une ligne a été retirée ou ajoutée.
measurements-row-added = { $path } : { $row } n’est pas dans measurements.csv ; ajout après coup.
measurements-u95-wrong = measurements.csv : { $id } a une U95 qui n’est pas 1,96 u ; l’un des deux est faux.
measurements-budget-sum = budget.csv : les contributions à { $id } donnent { NUMBER($total, minimumFractionDigits: 6, maximumFractionDigits: 6) } m, measurements.csv indique { NUMBER($told, minimumFractionDigits: 6, maximumFractionDigits: 6) } m ; l’un des deux est faux.
measurements-budget-differs = budget.csv : les contributions à { $id } diffèrent de son événement d’audit ; l’un des deux a été modifié.
cameras-calibration-images-changed = calibrations.csv : { $id } nomme d’autres photos que ses événements d’audit ; reprenez l’export complet.
measurements-event-another-row = audit.csv : un événement de la mesure { $id } contient une autre ligne que celle qu’il a hachée ; il a été modifié.
measurements-events-two-frames = audit.csv : deux événements décrivent différemment l’image { $frame } de l’enregistrement { $recording } ; l’un des deux a été modifié.
measurements-frame-time = vehicles.csv : l’image { $frame } de l’enregistrement { $recording } a un temps qui ne s’accorde pas avec les images voisines ; il a été modifié.
measurements-frame-table-differs = frames.csv : l’image { $frame } de l’enregistrement { $recording } diffère des événements d’audit de ses mesures ; elle a été modifiée.
measurements-frame-differs = { $path } : { $id } a été pointé sur une autre image que ne le dit frames.csv ; l’un des deux est faux.

## Erreurs : médias

media-import-cancelled = L’import de { $name } a été annulé ; rien n’en a été conservé.
media-image-too-large = { $name } annonce { $width } x { $height } pixels, plus de { $max_side_px } de côté ou { $max_pixels } millions en tout ; réduisez-le et réessayez.
media-not-decodable = { $name } est endommagé et ne peut pas être décodé ; enregistrez-le en PNG ou JPEG et réessayez.
media-empty-choose-picture = { $name } est vide ; choisissez une photo.
media-heif-picture = { $name } est une photo HEIC ou AVIF, illisible ici ; enregistrez-la en PNG ou JPEG et réessayez.
media-not-an-image = { $name } n’est pas une photo lisible ici ; enregistrez-la en PNG ou JPEG et réessayez.
media-header-damaged = { $name } est endommagé : son en-tête ne dit pas sa taille ; enregistrez-le en PNG ou JPEG et réessayez.
media-not-encodable = Une image de dimensions { $shape } n’a pas pu être encodée en { $suffix }.
media-file-too-large = { $name } dépasse { $max_bytes } Mo ; réduisez-le.
media-unreadable = { $name } est illisible ({ $strerror }) ; vérifiez le chemin.

## Erreurs : stockage

store-address-form = { $media_url } n’est pas une adresse de médias ; utilisez un dossier, file:///folder ou s3://bucket.
store-no-room = Il n’y a pas assez de place ({ NUMBER($needed_mb, maximumFractionDigits: 1) } Mo nécessaires, { NUMBER($free_mb, maximumFractionDigits: 1) } Mo libres) ; supprimez des enregistrements devenus inutiles ou ajoutez de l’espace disque, puis réessayez.
store-no-media-file = Il n’y a pas de fichier média { $key }.
store-no-cache = Le stockage sur S3 demande un dossier de cache local ; nommez-en un à côté de l’adresse des médias.
store-file-lost = Le fichier média { $key } manque dans le stockage ; restaurez-le depuis une sauvegarde.
store-no-answer = Le stockage des médias n’a pas répondu pour { $key } ({ $name }) ; vérifiez son adresse, ses identifiants et qu’il est en marche.
store-no-bucket = { $url } ne nomme pas de compartiment ; écrivez s3://bucket/prefix.
store-bucket-missing = Il n’y a pas de compartiment { $bucket }, et le stockage ne permet pas de le créer ({ $why }) ; créez-le, ou nommez-en un autre dans SIGHTLINE_MEDIA_URL.
store-file-missing = Le fichier média { $key } manque dans le stockage.
store-no-upload = Cet envoi n’existe pas ; il a été terminé ou abandonné, recommencez-le.
store-file-empty = Le fichier est vide ; choisissez un fichier vidéo.
store-upload-incomplete = L’envoi n’est pas complet : { NUMBER($have) } octets sur { NUMBER($size) } sont arrivés ; poursuivez-le.
store-upload-offset = L’envoi en est à l’octet { $have }, non { $at } ; poursuivez à partir de là.
store-upload-name-taken = Un envoi de ce nom est déjà en cours ; commencez-en un nouveau.
store-upload-busy = Cet envoi est en cours d’écriture par une autre connexion ; réessayez.
store-upload-superseded = Cet envoi se poursuit par une connexion plus récente ; celle-ci est terminée.
store-upload-too-long = Plus d’octets sont arrivés que les { NUMBER($size) } annoncés ; recommencez l’envoi.

## Erreurs : bandes

strips-notes-not-object = { $what } ne sont pas un objet JSON ; corrigez-les.
strips-rate-not-positive = { $what } donnent un line_rate_hz qui n’est pas un nombre positif ; corrigez-le.
strips-dropped-lines-form = { $what } donnent des dropped_lines qui ne sont pas une liste ordonnée de [line, count] ; corrigez-les.
strips-notes-too-large = { $what } dépassent { $sidecar_bytes } Mo ; corrigez ou supprimez ce fichier.
strips-notes-not-json = { $what } ne sont pas un JSON lisible ; corrigez ou supprimez ce fichier.
strips-header-cut-off = { $name } est tronqué dans son en-tête ; copiez-le à nouveau depuis l’enregistreur.
strips-in-colour = { $name } est en couleur, alors qu’un balayage est en niveaux de gris ; { strips-save-grey }.
strips-transparency = { $name } a une couche de transparence, alors qu’un balayage n’en a pas ; { strips-save-grey }.
strips-colour-with-transparency = { $name } est en couleur avec transparence, alors qu’un balayage est en niveaux de gris ; { strips-save-grey }.
strips-save-grey = enregistrez le fichier en niveaux de gris 8 ou 16 bits et réessayez
strips-copy-again = copiez de nouveau le fichier depuis l’enregistreur
strips-give-one-strip = donnez la bande d’une caméra
strips-say-time-axis = si le temps suit sa { $axis ->
    [width] largeur
   *[height] hauteur
}, dites-le
strips-bits-pixel = { $name } a { $depth } bits par pixel ; { strips-save-grey }.
strips-interlaced = { $name } est entrelacé et ne peut pas être lu par morceaux ; enregistrez-le sans entrelacement.
strips-png-too-wide = { $name } fait { $width_px } pixels de large, un PNG peut en avoir { $most_wide_px } ici ; enregistrez-le en TIFF ou avec le temps selon la hauteur.
strips-checksum-wrong = { $name } est endommagé : une somme de contrôle interne ne concorde pas ; copiez-le à nouveau depuis l’enregistreur.
strips-not-plain = { $name } n’est pas une image simple (animation, ou endommagée) ; { strips-save-grey }.
strips-not-an-image = { $name } { media-kind } ; indiquez un PNG ou TIFF de la caméra linéaire.
strips-heights-differ = { $name } a { $rows } pixels par ligne et { $name_2 } { $rows_2 } ; indiquez deux bandes de même hauteur, ou rognez-les à la partie de la scène que les deux montrent.
strips-bits-differ = { $name } a { $value } bits par pixel et { $name_2 } { $value_2 } ; enregistrez les deux de la même façon.
strips-lines-differ = { $name } a { NUMBER($lines) } lignes et { $name_2 } { NUMBER($lines_2) } ; toutes deux commencent et finissent ensemble : indiquez les deux bandes d’un même enregistrement, ou rognez-les à la même durée.
strips-not-a-file = { $name } n’est pas un fichier ; indiquez un PNG ou TIFF de la caméra linéaire.
strips-jpeg = { $name } est un JPEG, qui altère les pixels ; enregistrez-le en PNG ou TIFF dans l’enregistreur.
strips-lines-too-wide = { $name } aurait { $rows } pixels par ligne avec le temps selon sa { $time_axis ->
    [width] largeur
   *[height] hauteur
}, plus de { $most_rows } ; { $hint }.
strips-time-axis-wrong = { $name } a { NUMBER($lines) } lignes de { $rows } pixels avec le temps selon sa { $time_axis ->
    [width] largeur
   *[height] hauteur
}, ce qui ne montre aucun véhicule ; indiquez un PNG ou TIFF de la caméra linéaire.
strips-too-many-lines = { $name } a plus de { $most_lines } milliards de lignes ; découpez-le en parties.
strips-lost-lines-many = { $name } : ses notes disent que { NUMBER($lost) } lignes sur { NUMBER($lines) } ont été perdues ; refaites l’enregistrement.
strips-lost-lines-outside = { $name } : ses notes nomment des lignes perdues à { $line }, mais il finit à { $lines } ; corrigez-les.
strips-unreadable = { $name } est illisible ({ $strerror }) ; indiquez un PNG ou TIFF de la caméra linéaire.
strips-cut-off = { $name } est tronqué : il finit à la rangée { $row } sur { $height } ; copiez-le à nouveau depuis l’enregistreur.
strips-row-damaged = { $name } est endommagé à la rangée { $row } sur { $height } et illisible ensuite ; copiez-le à nouveau depuis l’enregistreur.
strips-size-impossible = { $name } annonce une image de { $width } x { $height } pixels ; copiez-le à nouveau depuis l’enregistreur.
strips-size-over-file = { $name } annonce { $width } x { $height } pixels, plus que n’en contient un fichier de { $file_bytes } Mo ; il est endommagé ou n’est pas un enregistrement : copiez-le à nouveau depuis l’enregistreur.
strips-rows-too-long = { $name } a des rangées de { $width_px } pixels, trop longues pour être lues ; copiez-le à nouveau depuis l’enregistreur.
strips-stored-damaged = La bande stockée { $name } est endommagée ; restaurez-la depuis une sauvegarde ou importez-la à nouveau.
strips-stored-missing = La bande stockée { $name } manque ; restaurez-la depuis une sauvegarde.
strips-spool-damaged = { $path } n’est pas une bande d’un flux, ou est endommagé ; laissez-le, et choisissez un autre --spool.
strips-no-level = La bande { $name } n’a pas de niveau { $level }, seulement 0 à { $last }.
strips-gain-range = Le gain { $gain } ne peut pas être affiché ; choisissez-en un de 0,1 à 50.
strips-no-tile = La bande { $name } n’a pas de tuile { $index } au niveau { $level }.
strips-index-size = a un index de pixels qui ne correspond pas à sa taille ; { strips-copy-again }
strips-several-images = { $name } contient plusieurs images ; donnez chaque bande en une seule longue image.
strips-palette = { $name } a une palette, et un balayage linéaire est en niveaux de gris ; { strips-save-grey }.
strips-not-grey = { $name } est en couleur ou a un canal de transparence, un balayage linéaire est en niveaux de gris ; { strips-save-grey }.
strips-number-kind = { $name } contient des nombres signés ou à virgule flottante ; { strips-save-grey }.
strips-bits-pixel-2 = { $name } a { $bitspersample } bits par pixel ; { strips-save-grey }.
strips-packing-unsupported = { $name } est compressé ({ $kind_name }), illisible ici ; enregistrez-le avec une compression zstd, deflate ou LZW, ou sans.
strips-packing-unusual = { $name } est compressé de façon inhabituelle ; enregistrez-le avec une compression zstd, deflate ou LZW, ou sans.
strips-not-upright = { $name } est marqué comme tourné ou en miroir ; enregistrez-le droit.
strips-tiff-cut-off = { $name } est un TIFF tronqué ou dont le répertoire est endommagé ; { strips-copy-again }.
strips-pieces-too-large = { $name } est compressé en morceaux de plus de { $piece_bytes } Mo ; enregistrez-le en bandes ou tuiles plus petites.
strips-tiles-too-large = { $name } a des rangées de tuiles de plus de { $piece_bytes } Mo ; enregistrez-le en tuiles plus petites.
strips-problem-2 = { $name } { $message }.
strips-tiff-damaged = { $name } est un TIFF dont le répertoire est endommagé ; { strips-copy-again }.
strips-too-few-frames = { $name } a { NUMBER($count) } images, trop peu pour un balayage linéaire ; choisissez un autre enregistrement.
strips-rate-uneven = { $name } n’a pas une cadence d’images constante (ses horodatages sont irréguliers, surtout après l’image { $at }), et un balayage linéaire en demande une ; extrayez une partie régulière, ou enregistrez à cadence fixe.
strips-cuts-unusable = Les { $what ->
    [rows] rangées
   *[columns] colonnes
} { $cut_1 } et { $cut_2 } ne peuvent pas être extraites de { $name } ; choisissez-en deux différentes de 0 à { $last_px }.
strips-frames-changed = { $name } a maintenant { NUMBER($count) } images, et non { NUMBER($count_2) } ; importez-le à nouveau.

## Erreurs : vidéo

video-not-a-file = { $name } n’est pas un fichier ; choisissez un fichier vidéo.
video-is-no-video = { $name } { media-kind }, non une vidéo ; choisissez un fichier vidéo.
video-is-empty = { $name } { media-kind } ; choisissez un fichier vidéo.
video-is-cut-off = { $name } { media-kind } ; copiez de nouveau le fichier depuis l’enregistreur, ou réparez-le sur place.
video-this-recording = Cet enregistrement
video-not-decoded-at = Cet enregistrement ne peut pas être décodé à l’image { $frame } : là, le décodeur { $why } ; convertissez-le en MP4 avec H.264 et envoyez-le de nouveau.
video-too-large-at = Cet enregistrement ne peut pas être décodé à l’image { $frame } : là, le décodeur { $why } ; convertissez-le en images plus petites et envoyez-le de nouveau.
video-decoder-memory = a eu besoin de plus de { $gigabytes } Go de mémoire, seul dans un nouveau processus
video-decoder-hung = s’est bloqué
video-decoder-killed = a été arrêté plusieurs fois, même seul dans un nouveau processus
video-decoder-crashed = s’est arrêté sur une erreur
video-decoder-ended = s’est arrêté
video-decoder-silent = n’a pas avancé pendant { $seconds } s
passes-camera-moves = La caméra bouge de { $far_px } px au plus ; la détection en tient compte. Une pose de la caméra ne vaut que tant que la caméra est immobile.
passes-camera-moves-too-far = La caméra bouge (de { $far_px } px et plus) ; la chaussée et les véhicules ne peuvent être séparés ; marquez les passages à la main.
passes-were-found = { $found ->
    [0] Aucun passage n’a été trouvé ; marquez-les à la main.
    [one] Un passage trouvé.
   *[other] Passages trouvés : { NUMBER($found) }.
}
passes-were-found-again = { $found ->
    [one] Un passage trouvé
   *[other] Passages trouvés : { NUMBER($found) }
} : { $new ->
    [0] aucun nouveau
   *[other] nouveaux : { NUMBER($new) }
}, connus ou écartés avant : { NUMBER($known) }.
scan-vehicles-found = Trouvés : { NUMBER($found) }, nouveaux : { NUMBER($added) }, mesurés de nouveau : { NUMBER($revised) }.
scan-vehicles-left = Laissés parce que quelqu’un les a modifiés entre-temps : { NUMBER($count) }.
media-kind = { $kind ->
    [empty] est vide
    [playlist] est une liste de lecture qui renvoie à d’autres fichiers
    [png] est une image PNG
    [jpeg] est une image JPEG
    [gif] est une image GIF
    [bmp] est une image BMP
    [tiff] est une image TIFF
    [webp] est une image WebP
    [heif] est une image HEIF ou AVIF
    [zip] est une archive zip
    [pdf] est un document PDF
    [gzip] est une archive gzip
    [rar] est une archive RAR
    [seven_zip] est une archive 7z
    [audio] est un fichier audio
    [ogg] est un fichier Ogg, que ce programme ne lit pas
    [text] est un fichier texte
    [cut_before_index] est coupé avant que son index (moov) soit écrit
    [cut_in_index] est coupé au milieu de son index (moov)
   *[other] n’est pas d’un format d’image pris en charge
}
video-no-video-track = { $name } ne contient pas de vidéo, seulement du son ou des données ; choisissez un fichier vidéo.
video-no-such-stream = { $name } n’a pas de piste vidéo { $number } ; il en contient { NUMBER($count) }, comptées à partir de 1.
video-track-is-still = La piste vidéo { $number } de { $name } est une image fixe ; choisissez une autre piste.
video-stream-is-off = La piste vidéo { $number } de { $name } est désactivée dans le fichier ; choisissez une autre piste.
video-slowed-in-part = Une partie seulement de { $name } est au ralenti : une seule cadence n’en donne pas les instants ; enregistrez-la avec les instants de prise de vue.
video-codec-unsupported = { $name } utilise un codec vidéo qui ne peut pas être décodé ici ; convertissez-le en MP4 avec H.264 ou choisissez un autre fichier.
video-size-missing = { $name } n’indique pas la taille de ses images, ou en indique une impossible ; convertissez-le en MP4 avec H.264 ou choisissez un autre fichier.
video-size-too-large = { $name } annonce une image de { $width } x { $height } pixels, plus de { $max_side_px } de côté ou { $max_pixels } millions en tout ; convertissez-le en MP4 avec H.264 ou choisissez un autre fichier.
video-aspect-implausible = { $name } annonce des pixels au rapport largeur sur hauteur de { $aspect }, ce qui n’est pas plausible ; convertissez-le en MP4 avec H.264 ou choisissez un autre fichier.
video-not-a-video = { $name } n’est pas une vidéo lisible ici ; convertissez-le en MP4 avec H.264 ou choisissez un autre fichier.
video-no-times-follow = { $name } ne donne pas l’instant de ses images : un véhicule ne peut pas y être suivi ; convertissez-le en MP4.
video-in-parts = { $name } est monté en plusieurs parties par une liste de montage ; les instants de ses images ne sont donc pas ceux de la prise de vue. Exportez chaque partie dans un fichier à part.
video-times-not-filming = Les instants de { $name } ne sont pas ceux de la prise de vue (ses remarques en donnent le motif) : aucun mouvement n’est mesuré. Saisissez sa cadence de prise de vue.
video-no-frame = { $name } ne contient aucune image décodable ; convertissez-le en MP4 avec H.264 ou choisissez un autre fichier.
video-set-aside = Cet enregistrement a fait planter le décodeur { NUMBER($count) } fois et est mis de côté ; convertissez-le en MP4 avec H.264 et envoyez-le à nouveau.
video-decoder-failing = Le décodeur s’est arrêté plusieurs fois de suite ; vérifiez la mémoire de cette machine.
video-not-decodable = { $header } ne peut pas être décodé : le décodeur { $why } ; enregistrez-le dans un autre format et réessayez.
video-frame-unwanted = Cette image n’était plus demandée.
video-frame-outside = Il n’y a pas d’image { $n } ; cet enregistrement a les images 0 à { $last }.
video-crop-outside = Un recadrage de { $w } x { $h } pixels à l’échelle { $scale } est hors limites ; demandez-en un plus petit.
video-no-frame-readable = { $name } ne contient aucune image décodable ; copiez-le à nouveau ou convertissez-le en MP4.
video-size-changes = { $name } change de taille d’image en cours de route ; coupez-le là où la taille change.
video-proposals-cancelled = La proposition de points pour { $name } a été annulée ; rien n’en a été conservé.
video-search-cancelled = La détection des passages dans { $name } a été annulée ; rien n’en a été conservé.
video-not-addressable = { $name } ne peut pas être rendu accessible image par image ; convertissez-le en MP4 avec H.264 et réessayez.
video-disk-full = Le disque est plein, { $name } n’a pas été importé ; libérez de la place et réessayez.
video-frame-changed = L’image { $n } ne peut pas être affichée : la vidéo stockée ne donne plus l’image dont la somme de contrôle a été notée à l’import ; restaurez le fichier depuis une sauvegarde ou importez-le comme nouvel enregistrement.
video-stored-missing = La vidéo stockée { $name } manque ou ne peut plus être ouverte ; restaurez-la depuis une sauvegarde.
video-numbered-frame-unwanted = L’image { $n } n’était plus demandée.
video-frame-form = { $name } demande des images BGR d’une même taille paire, reçu { $shape } pour { $width } x { $height }.
video-no-frames-written = { $name } ne peut pas être écrit sans images.

## Erreurs : personnes

people-sign-in-wrong = E-mail ou mot de passe incorrect. Réessayez.
people-password-length = Un mot de passe a de { $min_password } à { $max_password } caractères ; choisissez-en un autre.
people-sign-ins-slowed = Beaucoup de connexions depuis votre réseau ont échoué ; réessayez dans { $seconds } s.
people-password-one-sign = Un mot de passe a au moins { $least } caractères différents, sans compter les espaces ; choisissez-en un autre.
people-password-wrong = Le mot de passe actuel est incorrect ; saisissez-le à nouveau.
people-no-account = Il n’y a pas de compte actif pour { $email } ; vérifiez l’adresse.
people-sign-ins-blocked = Trop d’échecs de connexion ; attendez cinq minutes et réessayez.
people-token-incomplete = Un jeton demande un nom, un droit et de 1 à { NUMBER($most_days) } jours ; remplissez-les.
people-token-too-many = Vous avez déjà { NUMBER($most) } jetons ; révoquez-en un qui ne sert plus.
people-link-used = Ce lien de connexion a déjà servi ou est trop ancien ; demandez-en un nouveau à un administrateur.
people-link-switched-off = Le compte de { $person } est désactivé ; réactivez-le avant de créer un lien de connexion.
people-email-form = « { $email } » n’est pas une adresse e-mail ; écrivez-la sous la forme nom@lieu.
people-account-exists = Il existe déjà un compte pour { $email } ; modifiez plutôt celui-là.
people-last-admin = C’est le dernier administrateur ; nommez-en d’abord un autre.
people-no-name = Une personne doit avoir un nom ; indiquez-le.
people-role-unknown = Il n’y a pas de rôle « { $role } » ; utilisez l’un de { $roles }.

## Erreurs : poses

poses-frames-outside = Les images { $first_frame } à { $last_frame } ne sont pas une plage de { $name } ; il a les images 0 à { $frame_count }.
poses-board-not-shown = Images { $first } à { $last } : { $reason }
poses-calibration-image-size = L’étalonnage vaut pour des images de { $width_px } x { $height_px } px et { $name } a { $width_px_2 } x { $height_px_2 } px ; choisissez un étalonnage fait à la taille de l’enregistrement.
poses-calibration-other-survey = L’étalonnage { $calibration_id } appartient à un autre relevé ; choisissez-en un de ce relevé.

## Erreurs : qualité

quality-pose-unused = Plus aucun enregistrement n’utilise cette pose de la caméra ; rechargez la page Contrôles.
quality-direction-changed = La direction du trafic est maintenant de { $turn_deg }°, non la valeur affichée ; rechargez la page.
quality-frame-outside-pass = Le véhicule { $number } n’apparaît pas dans l’image { $frame } ; il passe dans les images { $first_frame } à { $last_frame }. Allez à l’une d’elles.
quality-repeats-too-few = { $name } a repointé { $pairs } de ses propres mesures ; il en faut { $least_pairs } pour une incertitude de pointé propre. Repointez-en d’autres.

## Erreurs : enregistrements

recordings-too-few-images = Photos de { $name } : { $images } ; ajoutez-en au moins trois, mieux 15 à 25.
recordings-other-survey = { $name } appartient à un autre relevé ; choisissez-en un de ce relevé.
recordings-no-pose = { $name } n’a pas encore de pose de la caméra : la position de sa caméra est inconnue.
recordings-not-ready = { $name } est encore en cours d’import ; attendez qu’il soit prêt.
recordings-import-failed = { $name } n’a pas pu être importé et n’a donc pas d’images ; voyez son erreur et réessayez.
recordings-frame-table-incomplete = La table des images de { $name } n’est pas complète ; importez à nouveau l’enregistrement.
recordings-frame-outside = L’enregistrement { $recording_id } n’a pas d’image { $n } ; choisissez-en une qu’il contient.
recordings-no-thumbnail = L’image { $n } de { $name } n’a pas de vignette ; demandez l’image elle-même.
recordings-importing-already = { $name } est déjà en cours d’import ; attendez ou annulez.
recordings-import-cancelled = L’import a été annulé ; relancez-le ou supprimez l’enregistrement.
recordings-importing = { $name } est en cours d’import ; annulez-le d’abord.
recordings-times-are-filming = Les instants de { $name } sont ceux de la prise de vue ; aucune cadence n’est nécessaire.
recordings-rate-in-use = Des mesures ou des balayages utilisent déjà la cadence de prise de vue de { $name } ; pour en utiliser une autre, envoyez le fichier à nouveau.
recordings-picture-is-there = La piste vidéo { $number } est déjà dans ce relevé, sous le nom { $name }.
recordings-field-unknown = { $unknown } d’un enregistrement n’est pas modifiable ; omettez-le.
recordings-no-name = Un enregistrement doit avoir un nom ; indiquez-le.
recordings-street-lighting-unknown = L’éclairage public était allumé ou éteint ; choisissez.
recordings-start-in-future = { $start }, fuseau { $zone }, n’est pas encore arrivé ; indiquez l’heure à laquelle l’enregistrement a commencé.
recordings-start-too-early = Il n’y avait pas de vidéo numérique le { $start } ; indiquez le jour où l’enregistrement a commencé.
recordings-misfit-size = Ses images font { $width } x { $height } px, mais l’étalonnage de sa caméra vaut pour { $lens_width } x { $lens_height } px : filmez à la taille étalonnée, ou étalonnez à celle-ci.
recordings-misfit-focal = Son fichier indique une focale de { $stated_mm } mm (équivalent 35 mm), mais l’étalonnage de sa caméra donne environ { $lens_mm } mm : contrôlez le zoom.
recordings-misfit-lamps = Son éclairage public était allumé, mais le relevé indique que la route n’en a pas : corrigez l’un des deux.
local-time-unknown-zone = { $zone } n’est pas un fuseau horaire de la liste IANA ; choisissez-en un comme Europe/Paris.
local-time-cannot-read = { $text } ne peut pas être lu comme une heure ; écrivez-la 2026-05-03T08:10:00.
local-time-skipped = { $time } n’existe pas dans le fuseau { $zone }, où les horloges l’ont sauté en avançant ; indiquez l’heure qu’elles affichaient ({ $before } avant le changement, { $after } après).
local-time-twice = { $time } se présente deux fois dans le fuseau { $zone }, où les horloges ont reculé ; dites si c’est la première ({ $first }) ou la seconde ({ $second }).
local-time-other-offset = À { $time }, les horloges du fuseau { $zone } sont à { $offset } ; indiquez ce décalage ou aucun.
measurements-filmed-time = measurements.csv : { $id } a été filmé à une autre heure que ne le donne le début de son enregistrement ; l’un des deux a été modifié.
measurements-state-differs = vehicles.csv : { $id } est { $told }, ses mesures en font { $state } ; l’un des deux a été modifié.
measurements-vehicle-time = vehicles.csv : { $id } a été filmé à une autre heure que ne le donne le début de son enregistrement ; l’un des deux a été modifié.
recordings-lighting-unknown = La luminosité est daytime ou low_light ; choisissez.
recordings-measured = Cet enregistrement a des mesures et ne peut pas être supprimé : un audit a besoin de ses images.
recordings-camera-not-moved = Aucun mouvement de la caméra n’a été détecté depuis sa pose ; il n’y a rien à décider.
recordings-pose-without-reason = Indiquez pourquoi la pose de la caméra vaut encore, pour qu’un audit puisse suivre la décision.
recordings-no-decision = Rien n’a été décidé sur la caméra de cet enregistrement : il n’y a rien à annuler.
recordings-named-other-survey = { $word ->
    [camera] Caméra
    [calibration] Étalonnage
    [recording] Enregistrement
   *[other] { $word }
} { $row_id } : appartient à un autre relevé ; choisissez dans ce relevé.
recordings-pose-image-size = La pose { $pose_id } de la caméra vaut pour des images de { $posed } x { $posed_2 } px et { $name } a { $filmed } x { $filmed_2 } px ; choisissez une pose faite à la taille de l’enregistrement.
recordings-frames-differ = Les images trouvées maintenant ne sont pas celles qui ont été mesurées ; envoyez la vidéo comme nouvelle.
recordings-tus-version = Les envois utilisent tus 1.0.0 ; envoyez l’en-tête Tus-Resumable: 1.0.0.
recordings-too-many-uploads = Vous avez { $most } envois incomplets ; terminez ou annulez-en d’abord.
recordings-uploads-no-room = Il n’y a pas de place pour cet envoi ({ NUMBER($needed_mb, maximumFractionDigits: 1) } Mo) à côté de vos envois incomplets ({ NUMBER($to_come_mb, maximumFractionDigits: 1) } Mo encore à venir, { NUMBER($free_mb, maximumFractionDigits: 1) } Mo libres) ; terminez ou annulez-en d’abord.
recordings-upload-without-length = L’envoi ne dit pas la longueur du fichier ; envoyez l’en-tête Upload-Length.
recordings-upload-content-type = Les octets d’un envoi arrivent en application/offset+octet-stream ; envoyez ce Content-Type.
recordings-upload-without-name = L’envoi ne nomme pas son fichier ; envoyez filename dans l’en-tête Upload-Metadata.
recordings-upload-purpose = Le but de l’envoi est video ou strip ; envoyez l’un des deux dans Upload-Metadata.
recordings-upload-metadata = { $word } de l’envoi est illisible ; envoyez-le en base64 d’UTF-8.
recordings-upload-finished = Cet envoi est déjà terminé ; cherchez son enregistrement dans la liste.
recordings-upload-of-deleted = Cet envoi est devenu un enregistrement supprimé depuis ; envoyez-le à nouveau.
recordings-upload-awaits-scan = Cet envoi est déjà terminé ; créez-en le balayage.
recordings-upload-is-recording = Cet envoi est terminé ; supprimez plutôt son enregistrement.

## Erreurs : résultats

results-cell-unreadable = { $path } : { $name } est illisible ; reprenez l’export complet.
results-word-unknown = La base de données contient { $name } « { $unknown } », que cette version ne connaît pas.
results-reference-u = La u des hauteurs de référence doit être d’au moins 0 et inférieure à 1 m, par exemple 0,0173.
results-own-values-many = Au plus { $most_own } valeurs propres peuvent être tracées ; retirez-en.
results-own-value-range = Une valeur propre doit être entre 0 et 10 m, par exemple 1,08.
results-standards-changed = Les normes ont été modifiées entre-temps ; rechargez-les et refaites votre modification.
results-standards-many = Un tableau de { NUMBER($count) } normes est trop long ; { $most } au plus.
results-standard-twice = { $twice } figure deux fois dans le tableau ; donnez à chaque valeur un nom propre.
results-standard-no-name = Une norme doit avoir un nom, par exemple AASHTO (USA).
results-standard-height = La hauteur de { $name } doit être entre 0 et 10 m, par exemple 1,08.
results-standard-percent = { $name } : un centile est supérieur à 0 et inférieur à 100 ; corrigez-le, ou laissez-le vide.
results-days-exchanged = Le dernier jour précède le premier ; inversez-les.
recordings-hours-are-none = Les heures commencent et finissent au même moment : rien n’y a été filmé ; choisissez une autre fin.
results-no-survey = Il n’y a pas de relevé { $survey_id } ; il a pu être supprimé.

## Erreurs : vérifications

reviews-fix-one-point = Une correction demande les deux points, contact et cible ; pointez-les et joignez-les.
reviews-fix-line-scan = Une hauteur de balayage ne se corrige pas à la vérification ; rejetez-la, ou remesurez-la sous Balayages.
reviews-points-without-fix = Seule une correction porte des points ; omettez-les ou choisissez la décision « corrigé ».
reviews-withdrawn = Cette mesure est retirée ; il n’y a rien à vérifier.
reviews-repeat = Une répétition ne se vérifie pas ; vérifiez la mesure qu’elle répète.
reviews-rejection-no-reason = Un rejet demande un motif ; indiquez ce qui ne va pas pour que ce soit corrigé.
reviews-fix-without-points = Une correction demande les nouveaux points, et seule une correction en a ; pointez-les et joignez-les.
reviews-plan-changed = Le plan a été modifié entre-temps ; rechargez-le et refaites votre modification.
reviews-plan-range = Saisissez un nombre de 0 (aucun contrôle en aveugle) à { $most }.
reviews-repeat-first = Le plan du relevé demande une répétition en aveugle de cette mesure ; pointez contact et cible, puis rendez votre décision.
reviews-fix-unchanged = Cette correction ne change rien ; déplacez un point, ou validez la mesure.
reviews-waits-review-already = Ceci attend déjà une vérification.
reviews-own-measurement = Vous ne pouvez pas vérifier votre propre mesure ; demandez à un autre vérificateur.
reviews-verdict-differs = measurements.csv : la décision sur { $one } n’est pas celle de sa dernière vérification ; l’une des deux est fausse.

## Erreurs : balayages

scans-calibrated-meanwhile = { $name } a étalonné ce balayage entre-temps ; contrôlez d’abord cet étalonnage.
scans-mark-outside = Un repère à la rangée { NUMBER($row_px, minimumFractionDigits: 1, maximumFractionDigits: 1) }, ligne { NUMBER($line, minimumFractionDigits: 0, maximumFractionDigits: 0) } est hors de la bande ; repointez-le.
scans-no-pose = Les hauteurs demandent la pose de la caméra linéaire ; étalonnez d’abord la hauteur avec un jalon (Étalonner la hauteur).
scans-side-missing = Le côté du conducteur de ce véhicule n’est pas indiqué ; choisissez d’abord proche ou éloigné.
scans-click-outside = Un pointé à la ligne { NUMBER($line, minimumFractionDigits: 0, maximumFractionDigits: 0) }, rangée { NUMBER($row, minimumFractionDigits: 1, maximumFractionDigits: 1) } est hors de la bande ; repointez.
scans-height-no-reason = Une cible qui n’a pas de hauteur demande un motif ; remesurez-la.
scans-height-withdrawn = Cette hauteur est déjà retirée ; il n’y a rien à faire.
scans-target-measured-meanwhile = { $name } a mesuré cette cible entre-temps ; contrôlez d’abord cette hauteur.
scans-calibration-no-row = { $path } : l’étalonnage { $marks } n’est dans aucune ligne de { $path_2 }.
scans-rig-needs-distance = Saisissez la distance des caméras aux véhicules : si les plans divergent, les vitesses utilisent la base à cette distance.
scans-rig-passes-without = { $path } : des passages de l’étalonnage { $id } existent, mais pas l’étalonnage lui-même ; une ligne manque.
scans-rig-passes-differ = { $path } : les passages de l’étalonnage { $id } ne sont pas ceux de son événement d’audit.
scans-rig-unsolvable = { $path } : les passages de l’étalonnage { $id } ne donnent aucun étalonnage ; l’un d’eux est faux.
scans-rig-differs = { $path } : { $name } de l’étalonnage { $id } n’est pas ce que donnent ses passages.
scans-marks-differ = { $path } : les repères de l’étalonnage { $id } ne sont pas ceux de son événement.
scans-current-not-newest = { $path } : une ligne marquée comme en vigueur n’est pas la dernière révision.
scans-height-no-row = { $path } : la hauteur { $budget } n’est dans aucune ligne de { $path_2 }.
scans-sources-differ = { $path } : les sources de la hauteur { $id } ne sont pas celles de ses pointés.
scans-marks-clicks-give = { $name } a { $column } { $told }, ses repères et pointés donnent { $computed }.
scans-marks-unsolvable = { $name } ne peut pas être calculé à partir de ses repères ; l’un d’eux est faux.
scans-no-motion = Ce véhicule n’a pas de mouvement mesuré : il n’y a pas de recalage à montrer.
scans-second-strip-ends = La bande de la caméra 2 finit avant ce véhicule : il n’y a pas de recalage à montrer.
scans-upload-twice = Les deux caméras nomment le même envoi ; envoyez une bande pour chacune.
scans-strips-same = { $name } et { $name_2 } sont la même image ; indiquez la bande de chaque caméra.
scans-frames-uneven = { $name } a des images à intervalles irréguliers, et un balayage linéaire demande une cadence régulière ; enregistrez à cadence d’images constante.
scans-cuts-unusable = { $what ->
    [rows] Les rangées
   *[columns] Les colonnes
} { $cut_1 } et { $cut_2 } ne peuvent pas être extraites ; choisissez-en deux différentes de 0 à { $last_px }.
scans-read-already = { $name } a déjà été importé ; il n’y a rien à faire.
scans-import-failed = { $name } n’a pas pu être importé ; voyez son erreur et réessayez.
scans-strips-taken-along = Un autre enregistrement ayant les mêmes bandes a été supprimé entre-temps ; elles sont relues.
scans-not-live = Aucun flux n’enregistre { $name } ; rien ne peut y être ajouté.
scans-live-one-strip = Il faut donner les deux bandes ou aucune ; envoyez le téléversement qui manque, ou aucun.
scans-measured-contradicts = Les valeurs du véhicule à la ligne { $line } se contredisent ; envoyez-les telles qu’elles ont été mesurées.
scans-still-being-recorded = { $name } est encore en cours d’enregistrement ; son image sera disponible quand cette partie du flux se terminera.
scans-not-ready = { $name } est encore en cours d’import ; attendez qu’il soit prêt.
scans-already-wait-cancel = { $name } : { $what ->
    [read] import
   *[searched] détection de véhicules
} déjà en cours ; attendez ou annulez.
scans-strip-other-survey = La { $word ->
    [first] première
   *[second] seconde
} bande a été envoyée à un autre relevé ; envoyez-la à celui-ci.
scans-upload-is-video = { $filename } a été envoyé comme vidéo ; envoyez-le à nouveau comme bande.
scans-upload-used = { $filename } appartient déjà à un enregistrement de balayage linéaire ; envoyez-le à nouveau.
scans-strip-incomplete = La { $word ->
    [first] première
   *[second] seconde
} bande, { $filename }, n’est pas encore arrivée en entier ; terminez son envoi.
scans-changed-meanwhile = { $name } a modifié { $name_2 } le { $when } ; rechargez-le et refaites votre modification.
scans-field-unknown = { $unknown } d’un balayage n’est pas modifiable ; omettez-le.
scans-start-u-range = Une incertitude du début de { $u_s } s est hors plage ; saisissez une incertitude-type supérieure à 0 et d’au plus 3600 s.
scans-vehicle-time-differs = { $path } : le véhicule { $number } est passé à une autre heure que ne le donnent le début de son enregistrement et ses lignes ; l’un des deux a été modifié.
scans-rig-not-sound = { $path }, ligne { $id } : le dispositif ne peut pas être tel qu’il y figure (base, cadence de lignes, voies ou autre valeur) ; reprenez l’export complet.
scans-gap-differs = { $path } : { $name } du véhicule { $number } n’est pas ce que donnent son mouvement et celui d’avant ; l’un des deux a été modifié.
scans-direction-differs = { $path } : la révision { $number } a un autre sens que ne le donnent ses lignes devant les deux caméras ; l’un des deux a été modifié.
scans-axles-without-motion = Les essieux ne se comptent que sur un véhicule dont le mouvement est mesuré ; ce n’est pas le cas ici.
scans-axle-outside-vehicle = Un essieu est hors du véhicule ; pointez son moyeu entre l’avant et l’arrière.
scans-traffic-no-start = Le début de ce balayage n’est pas confirmé ; confirmez-le, et son trafic sera compté par tranche horaire.
scans-traffic-other-minutes = Le trafic ne se compte pas en tranches de { $minutes } min ; choisissez 1, 5, 15 ou 60.
scans-traffic-not-read = Ce balayage n’est pas importé : son trafic est inconnu.
scans-traffic-other-rate = Des véhicules de ce balayage ont été mesurés avec une autre cadence de lignes ; son trafic est inconnu. Mesurez-les à nouveau.
scans-traffic-overlap = { $others ->
    [0] { $earlier } et { $later } se chevauchent pendant { NUMBER($seconds) } s : un véhicule présent dans les deux est compté dans chacun.
    [one] { $later } chevauche { $earlier } pendant { NUMBER($seconds) } s et un autre qui précède : un véhicule présent dans plusieurs est compté dans chacun.
   *[other] { $later } chevauche { $earlier } pendant { NUMBER($seconds) } s et { NUMBER($others) } autres qui précèdent : un véhicule présent dans plusieurs est compté dans chacun.
}
scans-no-name = Un balayage doit avoir un nom ; indiquez-le.
scans-worked-on = Des personnes ont travaillé sur les véhicules de ce balayage : il ne peut pas être supprimé, car un audit a besoin de ses bandes.
scans-recording-other-survey = L’enregistrement appartient à un autre relevé ; choisissez-en un de ce relevé.
scans-unread = { $name } n’a pas encore été importé ; attendez qu’il soit prêt.
scans-cameras-worked-on = Des personnes ont travaillé sur { $name } : ses caméras ne peuvent pas être échangées ; ajoutez un balayage aux bandes échangées.
scans-vehicle-not-measured = Ce véhicule n’est pas encore mesuré et n’a donc pas d’empattement ; placez d’abord ses bornes.
scans-wheel-outside = Une roue est hors des bandes, qui finissent à la ligne { $lines }.
scans-front-after-rear = À la caméra { $camera }, l’avant (ligne { NUMBER($front, minimumFractionDigits: 1, maximumFractionDigits: 1) }) doit précéder l’arrière ({ NUMBER($rear, minimumFractionDigits: 1, maximumFractionDigits: 1) }) ; replacez-les.
scans-boundaries-outside = Les bornes à la caméra { $camera } sont hors de la bande, qui finit à la ligne { $lines } ; replacez-les.
scans-boundaries-far-apart = L’avant et l’arrière à la caméra { $camera } sont à { NUMBER($rear, minimumFractionDigits: 0, maximumFractionDigits: 0) } lignes l’un de l’autre, plus qu’un véhicule n’en occupe ; replacez-les.
scans-second-camera-blank = Rien dans la bande de la caméra 2 ne ressemble à ce véhicule ; placez-y son avant et son arrière à la main, ou retirez-le si ce n’en est pas un.
scans-speed-no-reason = Un véhicule qui n’a pas de vitesse demande un motif ; remesurez-le.
scans-vehicle-measured-meanwhile = Ce véhicule a été remesuré entre-temps ; contrôlez le nouveau résultat.
scans-own-boundaries = Vous ne pouvez pas vérifier les bornes que vous avez placées ; demandez à un autre vérificateur.
scans-second-camera-half = La caméra 2 demande les deux lignes, avant et arrière, ou aucune ; envoyez les deux ou omettez les deux.
scans-wheel-missing = Un empattement demande les deux roues ; envoyez les deux lignes, ou aucune pour les retirer.
scans-vehicle-not-deleted = Ce véhicule n’a pas été supprimé : il n’y a rien à restaurer.
scans-vehicle-deleted = { $name } a supprimé le véhicule { $number } le { $when } ; restaurez-le d’abord.
scans-vehicle-changed = { $name } a modifié le véhicule { $number } le { $when } ; rechargez-le et refaites votre modification.
scans-vehicle-field-unknown = Un véhicule balayé n’a pas de { $unknown } ; omettez-le.
scans-metres-range = { $name } de { $value } m : hors plage ; indiquez cette dimension en mètres, par exemple 4,447.
scans-vehicle-not-newest = { $path } : le véhicule { $number } n’est pas sa dernière révision ; il a été modifié.
scans-verdict-went-over = { $path } : la ligne { $id } porte une décision rendue sur une autre mesure ; reprenez l’export complet.
scans-verdict-differs = { $path } : la décision de la ligne { $number } n’est pas celle qui a été rendue.

## Erreurs : statistiques

statistics-percentile-range = Il n’y a pas de centile { $percent } ; indiquez-en un entre 0 et 100, par exemple 10.
statistics-width-not-positive = Largeur et dispersion doivent être des longueurs supérieures à 0, en mètres, par exemple 0,02 et 0,08.

## Erreurs : relevés

surveys-photograph-missing = Le fichier de la photo « { $name } » manque ou a été modifié ; retirez-la du relevé et ajoutez-la à nouveau.
surveys-photographs-many = Un relevé contient au plus { $most_photographs } photos ; retirez-en une avant d’en ajouter une autre.
surveys-photographs-changed = Des photos ont été ajoutées ou retirées entre-temps ; rechargez et refaites l’ordre.
surveys-photograph-changed = { $name } a modifié cette photo le { $when } ; rechargez-la et refaites votre modification.
surveys-caption-long = Une légende a au plus { $most_caption } caractères ; raccourcissez-la.
surveys-no-row-put = { $strange } n’est dans aucune ligne de { $path } ; ajouté après coup.
surveys-photograph-replaced = { $file } n’est pas la photo que nomme son événement d’audit ; elle a été échangée.
surveys-no-survey = Il n’y a pas de relevé nommé « { $name } » ; vérifiez le nom sur la page d’accueil.
surveys-changed-meanwhile = { $name } a modifié ce relevé le { $when } ; rechargez-le et refaites votre modification.
surveys-place-half-coordinates = Des coordonnées sont une latitude et une longitude ; indiquez les deux ou aucune.
surveys-place-latitude = Une latitude est entre −90 et 90 degrés, pas { $latitude } : latitude et longitude sont-elles inversées ?
surveys-place-longitude = Une longitude de { $longitude } est hors plage ; indiquez de −180 à 180 degrés.
surveys-place-speed-limit = Une vitesse limite de { $kmh } km/h est hors plage ; indiquez une valeur supérieure à 0 et d’au plus { $fastest } km/h.
surveys-no-name = Un relevé doit avoir un nom ; indiquez-le.
surveys-inset-unusable = Le retrait de « { $target } » est inutilisable ; indiquez une cible connue et une incertitude positive ou nulle.
surveys-asks-nothing = Un relevé demande au moins une cible de jour et une en faible luminosité ; choisissez-les.
surveys-sampling-step = Un passage sur n : n est entre 1 et { $most_step }, le premier numéro entre 1 et n ; corrigez-les.
surveys-sampling-share = Une part des passages est supérieure à 0 et d’au plus 100 % ; corrigez-la.
surveys-sampling-headway = Le temps intervéhiculaire des véhicules libres doit être supérieur à 0 et d’au plus { $most_headway_s } s ; corrigez-le.
surveys-sampling-quota-twice = Une luminosité et un groupe de classes ont deux quotas ; indiquez chacun une seule fois.
surveys-class-twice = La classe { $category } figure deux fois dans le tableau ; indiquez chaque classe une seule fois.
surveys-class-fhwa = Une classe FHWA de { $category } n’est pas comprise entre 1 et 13 ; corrigez-la.

## Erreurs : véhicules

vehicles-no-row-used-line = Aucune ligne de { $name } n’est utilisable ; ligne { $line } : { $reason }
csv-too-large = { $name } dépasse { $most_bytes } Mo ; répartissez-le en plusieurs fichiers.
vehicles-column-missing = { $name } n’a pas de colonne { $missing } ; sa première ligne nomme les colonnes, parmi { $known }.
vehicles-category-unknown = « { $category } » n’est pas une catégorie ; utilisez l’une de { $categories }.
vehicles-not-a-year = { $column } vaut « { $cell } », qui n’est pas une année ; indiquez quatre chiffres.
csv-empty = { $name } est vide ; sa première ligne doit nommer les colonnes { $needed }.
csv-no-column = { $name } n’a pas de colonne { $missing } ; sa première ligne doit nommer les colonnes { $needed }.
csv-column-twice = { $name }, ligne { $line } : la colonne { $column } est nommée deux fois ; gardez celle qui compte.
csv-column-expanded = La colonne « { $column } » de { $name } porte le U majuscule ou le U95 d’une incertitude élargie ; donnez l’incertitude-type (k = 1) dans une colonne précédée de « u_ ».
csv-more-cells = { $name }, ligne { $line } : { $cells } cellules, mais l’en-tête en nomme { $columns } ; écrivez les décimales avec un point, non une virgule, et mettez entre guillemets les textes qui ont des virgules.
csv-fewer-cells = { $name }, ligne { $line } : { $cells } cellules, alors que l’en-tête en nomme { $columns } ; complétez la ligne.
csv-header-again = { $name }, ligne { $line } : elle nomme à nouveau les colonnes, comme là où des tableaux ont été réunis ; ôtez cette ligne.
csv-open-quote = { $name }, ligne { $line } : un guillemet n’est pas fermé sur sa ligne ; fermez-le ou ôtez-le, et ne mettez pas de saut de ligne dans une cellule.
csv-after-a-quote = { $name }, ligne { $line } : du texte suit un guillemet fermant ; doublez un guillemet dans une cellule, ou ôtez-le.
csv-cell-not-closed = { $name }, ligne { $line } : c’est peut-être la suite de la cellule que la ligne { $opened } ne ferme pas ; corrigez les deux lignes.
csv-empty-cell = { $name }, ligne { $line } : { $column } est vide ; remplissez la cellule.
csv-not-a-number = { $name }, ligne { $line } : { $column } vaut « { $cell } », qui n’est pas un nombre ; corrigez la cellule.
csv-number-separated = { $name }, ligne { $line } : { $column } vaut « { $cell } » ; écrivez les décimales avec un point et rien entre les milliers.
csv-size-too-large = { $name }, ligne { $line } : { $column } vaut « { $cell } », et aucun véhicule n’a plus de 20 m ; en { $unit }, ce serait { $metres } m. Indiquez des mètres.
csv-size-not-positive = { $name }, ligne { $line } : { $column } vaut « { $cell } » ; une dimension est supérieure à 0. Corrigez la cellule.
csv-uncertainty-below-0 = { $name }, ligne { $line } : { $column } vaut « { $cell } » ; une incertitude n’est pas négative. Corrigez la cellule.
csv-not-utf-8 = { $name } n’est pas un texte UTF-8 ; enregistrez-le en CSV UTF-8.
vehicles-frames-changed = { $name } a maintenant { NUMBER($count) } images et en avait { NUMBER($count_2) } à l’import ; importez-le à nouveau.
vehicles-search-running = Une détection des passages de { $name } est déjà en cours ; attendez la fin.
vehicles-no-frames = Un véhicule demande sa première et sa dernière image ; marquez le passage sur la frise.
vehicles-year-to-come = Aucun modèle de { $year } n’a pu passer encore ; donnez une année jusqu’à { $most }.
vehicles-field-unknown = Un véhicule n’a pas de { $unknown } ; omettez-le.
vehicles-frames-outside = Les images { $first } à { $last } ne sont pas une plage de cet enregistrement ; il finit à l’image { $end }.
vehicles-best-frame-outside = La meilleure image { $best } est hors des images { $first } à { $last } ; choisissez l’une d’elles.
vehicles-model-size-unknown = { $size } n’est pas une dimension d’un modèle ; donnez-en parmi { $known }.
vehicles-model-without-sizes = Un modèle choisi d’après ses dimensions doit dire lesquelles ; ajoutez model_sizes.
vehicles-no-driver-target = « Aucun conducteur visible » est un motif pour l’œil du conducteur, non pour { $target } ; choisissez-en un autre.
vehicles-known-height-range = Une hauteur connue de { $height } m est inutilisable ; indiquez-la en mètres, par exemple 1,624.
vehicles-known-height-kind = { $target ->
    [roof] Aucun toit
    [driver_eye] Aucun œil de conducteur
    [taillight] Aucun feu arrière
    [headlight] Aucun projecteur
   *[other] Aucun repère
} n’est à { $height } m au-dessus de la route ; indiquez des mètres, de { $low } à { $high }.
vehicles-u-range = Une incertitude de { $u_height } m est inutilisable ; indiquez-la en mètres, par exemple 0,005.

## Erreurs : ce que le cadre logiciel refuse, et ce qui a été dit avant

said = { $sentence }
request-needs-header = Les requêtes qui modifient quelque chose demandent l’en-tête { $header } ; ajoutez-le et renvoyez.
request-from-another-site = Cette requête vient d’un autre site et a été refusée ; utilisez les pages de Sightline.
request-no-json = Le corps de la requête n’est pas un JSON valide ; envoyez un objet JSON.
request-cannot-be-used = La partie { $place } de la requête est inutilisable : { $said } ; corrigez-la et renvoyez.
request-value-unusable = La valeur « { $name } » de la partie { $place } est inutilisable : { $said } ; corrigez-la et renvoyez.
request-extra = champ inconnu
request-missing = champ obligatoire
request-finite = doit être un nombre fini
request-boolean = doit être vrai ou faux (true, false)
request-integer = doit être un nombre entier
request-number = doit être un nombre
request-text = doit être un texte
request-list = doit être une liste
request-object = doit être un objet
request-above = doit être supérieur à { $gt }
request-least = doit être supérieur ou égal à { $ge }
request-below = doit être inférieur à { $lt }
request-most = doit être inférieur ou égal à { $le }
request-text-long = le texte doit avoir au plus { $max_length } caractères
request-pattern = le texte doit suivre le modèle { $pattern }
request-said = une phrase est faite de son code et de ses valeurs
request-nul = un texte ne peut pas contenir le caractère NUL
request-date = doit être une date, comme 2026-05-04
request-datetime = doit être une date et une heure, comme 2026-05-04T08:10:00
request-time-zone = doit comporter son fuseau horaire, comme 2026-05-04T08:10:00Z
request-one-of = doit être l’une de ces valeurs : { $expected }
request-list-short = la liste a { $actual_length ->
    [one] { $actual_length } élément
   *[other] { $actual_length } éléments
}, il en faut au moins { $min_length }
request-list-long = la liste a { $actual_length } éléments, au plus { $max_length ->
    [one] { $max_length } est admis
   *[other] { $max_length } sont admis
}
request-text-short = le texte doit avoir au moins { $min_length ->
    [one] { $min_length } caractère
   *[other] { $min_length } caractères
}
request-nothing-there = Il n’y a rien à { $path } ; vérifiez l’adresse.
request-bad-method = { $method } n’est pas possible à { $path } ; voyez /docs pour ce qui l’est.
request-refused = { $detail } ; corrigez et réessayez.
request-done-before = Cette requête a été enregistrée à son premier envoi, et sa réponse n’est pas gardée ; lisez ce qu’il y a maintenant.
request-key-malformed = Une Idempotency-Key a de 1 à 100 lettres, chiffres, points, deux-points ou tirets ; envoyez un nouvel UUID pour chaque écriture.
request-key-of-another = L’Idempotency-Key { $key } a déjà été envoyée avec une autre requête ; faites une nouvelle clé pour chaque écriture.
request-value-not-storable = Une valeur de la requête ne peut pas être stockée ; corrigez-la et renvoyez.
server-something-went-wrong = Un problème est survenu sur le serveur et rien n’a été enregistré ; voyez le journal du serveur.

## Erreurs : une autre personne a été plus rapide

quality-tyres-changed-meanwhile = { $name } a modifié les pneus de ce véhicule entre-temps ; contrôlez-les d’abord.
measurements-discard-measured = Le véhicule { $number } est mesuré et ne peut donc pas être écarté ; retirez d’abord ses mesures.
measurements-sample-differs = vehicles.csv : l’appartenance du véhicule { $id } à l’échantillon, ou à ce qui compte, n’est pas ce que donnent sampling.csv et les passages ; il a été modifié.
measurements-invisible-measured = { $target } : mesuré sur ce véhicule, donc visible ; retirez d’abord la mesure.
measurements-already-measured = { $name } a déjà mesuré cette cible du véhicule ; gardez l’une des deux.
lots-lead = Les mesures peuvent être vérifiées par lots : un échantillon de chaque lot est vérifié, puis le lot est accepté ou contrôlé en entier. Le plan indique le risque de décision erronée dans chaque sens. Les hauteurs des balayages se vérifient dans la file.
lots-loading = lots
lots-summary = Mesures validées : { $individual } individuellement, { $by_lot } par l’échantillon de leur lot.
lots-outgoing = { $count ->
    [one] Sur { NUMBER($count) } non vérifiée individuellement, fausses : { $estimate } selon l’estimation et { $most } au plus ({ $share }, unilatéral à 95 %).
   *[other] Sur les { NUMBER($count) } non vérifiées individuellement, fausses : { $estimate } selon l’estimation et { $most } au plus ({ $share }, unilatéral à 95 %).
  }
lots-held = { $count ->
    [one] { NUMBER($count) } hauteur attend l’échantillon de son lot.
   *[other] { NUMBER($count) } hauteurs attendent l’échantillon de leur lot.
  }
lots-draw-title = Tirer des lots de la file
lots-draw = Tirer
lots-by = Point commun des hauteurs d’un lot
lots-by-target = cible
lots-by-lighting = luminosité
lots-by-operator = auteur de la mesure
lots-by-day = jour de la mesure
lots-risk-producer_quality = Part de hauteurs fausses à laquelle un lot devrait passer
lots-risk-producer_risk = Risque qu’il ne passe pas
lots-risk-consumer_quality = Part de hauteurs fausses à laquelle un lot ne devrait pas passer
lots-risk-consumer_risk = Risque qu’il passe
lots-nonconforming = Une hauteur est fausse (non conforme) si son vérificateur la rejette, ou la corrige de plus que son U95. L’échantillon est tiré avec une graine issue de la chaîne d’audit, avant toute vérification. Le critère d’acceptation est celui de l’ISO 2859 ; ses tables ne sont pas utilisées : le plan est calculé pour l’effectif de chaque lot.
lots-nothing-waits = Aucune hauteur n’attend de vérification en dehors des lots.
lots-planned = Lots possibles
lots-lot = Lot
lots-size = Hauteurs
lots-sample = Échantillon
lots-number = Fausses admises
lots-what = Gain
lots-saves = { $count ->
    [one] { NUMBER($count) } décision
   *[other] { NUMBER($count) } décisions
  }
lots-saves-nothing = aucun : l’échantillon est tout le lot ; vérifiez les hauteurs une à une
lots-everything = toutes les hauteurs de la file
lots-named = Lot { $number } : { $common }
lots-of = { NUMBER($part) } sur { NUMBER($all) }
lots-judged = Vérifiées
lots-bad = Fausses
lots-state = État
lots-state-open = ouvert
lots-state-accepted = accepté
lots-state-full_inspection = contrôle complet
lots-state-dissolved = dissous
lots-state-taken_back = annulé
lots-left = Sorties du lot : { $reasons }.
lots-left-measured_again = remesurées ({ NUMBER($count) })
lots-left-withdrawn = retirées ({ NUMBER($count) })
lots-left-vehicle_deleted = au véhicule supprimé ({ NUMBER($count) })
lots-left-verdict_of_its_own = avec décision individuelle ({ NUMBER($count) })
lots-plan = { $size } hauteurs, échantillon de { $sample }, fausses admises : { $most }.
lots-says-waits = { $count ->
    [one] { NUMBER($count) } de l’échantillon attend encore sa décision.
   *[other] { NUMBER($count) } de l’échantillon attendent encore leur décision.
  }
lots-says-accept = { $count ->
    [one] Échantillon vérifié : { NUMBER($count) } est fausse (admises : { $most }). Le lot peut être accepté.
   *[other] Échantillon vérifié : { NUMBER($count) } sont fausses (admises : { $most }). Le lot peut être accepté.
  }
lots-says-refused = { $count ->
    [one] { NUMBER($count) } de l’échantillon est fausse (admises : { $most }) : le reste passe au contrôle complet.
   *[other] { NUMBER($count) } de l’échantillon sont fausses (admises : { $most }) : le reste passe au contrôle complet.
  }
lots-says-accepted = { $count ->
    [one] Accepté ; fausses dans l’échantillon : { $bad } ; { NUMBER($count) } hauteur acceptée d’après lui, fausses : { $estimate } selon l’estimation et { $most } au plus ({ $share }, unilatéral à 95 %).
   *[other] Accepté ; fausses dans l’échantillon : { $bad } ; { NUMBER($count) } hauteurs acceptées d’après lui, fausses : { $estimate } selon l’estimation et { $most } au plus ({ $share }, unilatéral à 95 %).
  }
lots-says-inspected = { $count ->
    [one] Non accepté d’après son échantillon : { NUMBER($count) } hauteur est passée à la file.
   *[other] Non accepté d’après son échantillon : { NUMBER($count) } hauteurs sont passées à la file.
  }
lots-says-taken-back = { $count ->
    [one] Accepté, puis annulé : { NUMBER($count) } hauteur attend à nouveau.
   *[other] Accepté, puis annulé : { NUMBER($count) } hauteurs attendent à nouveau.
  }
lots-says-dissolved = Dissous avant le début de la vérification.
lots-judge = Vérifier l’échantillon
lots-accept = Accepter le lot
lots-inspect = Contrôle complet
lots-inspect-text = { $count ->
    [one] { NUMBER($count) } hauteur du reste passe à la file et n’entre dans aucun autre lot.
   *[other] { NUMBER($count) } hauteurs du reste passent à la file, individuellement, et n’entrent dans aucun autre lot.
  }
lots-dissolve = Dissoudre
lots-take-back = Annuler
lots-own = { $count ->
    [one] { NUMBER($count) } de l’échantillon est la vôtre ; une autre personne la vérifie.
   *[other] { NUMBER($count) } de l’échantillon sont les vôtres ; une autre personne les vérifie.
  }
lots-drawn = Tiré { $when } par { $person } ; graine { $seed }…
lots-nobody = Sightline
lots-curve = Probabilité d’acceptation
lots-curve-says = La probabilité que le plan accepte un lot, décroissante avec la part de hauteurs fausses : avec { $good } de fausses il n’est pas accepté dans { $refused } des cas, avec { $bad } il est accepté dans { $passed }.
lots-curve-note = Exact pour un lot de cet effectif (loi hypergéométrique). Avec { $good } de fausses, { $refused } de ces lots ne sont pas acceptés ; avec { $bad }, { $passed } le sont.
lots-curve-x = hauteurs fausses du lot (%)
lots-curve-y = acceptés (%)
lots-producer = devrait passer
lots-consumer = ne devrait pas passer
lots-sample-of = échantillon du lot { $number }
lots-badge = lot { $number }
lots-sample-done = L’échantillon de ce lot est vérifié. Il reste à décider du lot.
lots-sample-done-title = L’échantillon est vérifié
lots-decide = Décider du lot
lots-show-all = Tout afficher
lots-by-lot = Acceptée d’après l’échantillon de son lot ; non vérifiée individuellement.
lots-fraction-between = Saisissez une proportion de non conformes de 0 à moins de 1, par exemple 0,01 pour 1 sur 100.
lots-risk-between = Saisissez un risque de 0,001 à 0,5, par exemple 0,05 pour 1 sur 20.
lots-fractions-in-order = La proportion d’un lot qui devrait passer doit être plus petite que celle d’un lot qui ne devrait pas ; modifiez l’une d’elles.
lots-nothing-to-draw = Aucun lot n’épargnerait de travail : trop peu de hauteurs attendent pour ces risques, ou elles sont déjà dans des lots. Divisez moins, ou vérifiez-les une à une.
lots-sample-not-judged = { $count ->
    [one] { NUMBER($count) } hauteur de l’échantillon attend encore sa décision ; vérifiez-la d’abord.
   *[other] { NUMBER($count) } hauteurs de l’échantillon attendent encore leur décision ; vérifiez-les d’abord.
  }
lots-too-many = { $count ->
    [one] { NUMBER($count) } hauteur de l’échantillon est non conforme ; ce lot est accepté avec { $most } au plus : le reste passe au contrôle complet.
   *[other] { NUMBER($count) } hauteurs de l’échantillon sont non conformes ; ce lot est accepté avec { $most } au plus : le reste passe au contrôle complet.
  }
lots-own-heights = Vous ne pouvez pas accepter vos propres hauteurs, et le reste de ce lot en contient. Demandez à un autre vérificateur.
lots-judged-already = Une partie de cet échantillon est déjà vérifiée : le lot ne peut pas être dissous ; acceptez-le ou contrôlez-le en entier.
lots-not-accepted = Seul un lot accepté peut être annulé ; contrôlez l’état de celui-ci.
lots-decided-already = Le lot { $number } a reçu une décision entre-temps ; contrôlez-la d’abord.
lots-event-another-row = audit.csv : l’événement { $number } contient un autre lot que celui qu’il a haché ; reprenez l’export complet.
lots-verdict-without-lot = reviews.csv : une décision par le lot { $lot }, qui n’existe pas ; reprenez l’export complet.
lots-seed-differs = lots.csv : la graine du lot { $id } ne découle pas de la chaîne d’audit ; le tirage a été choisi.
lots-order-differs = audit.csv : le lot { $id } n’a pas été tiré dans l’ordre de sa graine ; le tirage a été modifié.
lots-plan-risk = lots.csv : le plan du lot { $id } ne respecte pas les risques qu’il nomme ; il a été modifié.
lots-decided-otherwise = audit.csv : les décisions sur le lot { $id } ne découlent pas l’une de l’autre ; elles ont été modifiées.
lots-sample-differs = audit.csv : l’échantillon du lot { $id } n’est pas le début de son tirage ; il a été modifié.
lots-counts-differ = audit.csv : les nombres du lot { $id } ne sont pas ceux des décisions de son échantillon ; l’un des deux est faux.
lots-beyond-plan = audit.csv : le lot { $id } a été accepté avec plus de hauteurs non conformes que son plan n’en admet, ou sans vérification.
lots-rest-differs = reviews.csv : les décisions par le lot { $id } ne sont pas celles de son reste ; certaines ont été ajoutées ou retirées.
lots-verdict-too-early = audit.csv : une décision par le lot { $id } précède la décision sur le lot ; l’une des deux est fausse.
reviews-verdict-given-meanwhile = { $name } a rendu entre-temps la décision « { $verdict ->
    [accepted] { state-accepted }
    [fixed] { state-fixed }
    [rejected] { state-rejected }
    [reopened] { state-reopened }
   *[to_review] { state-to_review }
} » ; contrôlez-la d’abord.

## Distance de visibilité : la page

sight-lead = Effet des hauteurs mesurées sur la conception des routes : angles saillants qui assurent une distance de visibilité, avec les hauteurs d’une norme et avec celles du relevé.
sight-loading = angles saillants
sight-form = Données d’entrée
sight-form-standard = Norme
sight-form-survey = Relevé, aux centiles de la norme
sight-form-road = Route
sight-form-fleet = Autre parc : part de chaque classe
sight-eye = Œil de la norme
sight-object = Obstacle de la norme
sight-standard-option = { $standard }, { $what } : { $height }
sight-standard-any = Hauteur libre
sight-standard-height = Hauteur
sight-eye-percent = Yeux, centile
sight-object-target = Obstacle
sight-object-standard = Hauteur de la norme
sight-object-percent = Obstacles, centile
sight-kind = Distance de visibilité
sight-kind-stopping = Arrêt
sight-kind-decision_a = Décision, arrêt sur route de rase campagne
sight-kind-decision_b = Décision, arrêt sur voie urbaine
sight-kind-decision_c = Décision, manœuvre sur route de rase campagne
sight-kind-decision_d = Décision, manœuvre sur route périurbaine
sight-kind-decision_e = Décision, manœuvre sur voie urbaine
sight-kind-passing = Dépassement
sight-kind-intersection_left = Carrefour, tourne-à-gauche depuis un arrêt
sight-kind-intersection_right = Carrefour, tourne-à-droite ou traversée
sight-speed = Vitesse de référence
sight-difference = Différence de déclivités
sight-headlight = Projecteur (angle rentrant)
sight-radius = Rayon (virage)
sight-number-problem = Ce nombre est hors plage ; corrigez-le.
sight-fleet-begin = Essayer un autre parc
sight-fleet-hint = Parts des classes mesurées ; modifiez-les au besoin.
sight-fleet-end = Parc mesuré
sight-fleet-measured = Yeux mesurés : { NUMBER($eyes) }, obstacles : { NUMBER($objects) }
sight-case = Hauteurs de
sight-case-standard = la norme
sight-case-survey = le relevé
sight-case-mix = l’autre parc
sight-sentence = Résultat
sight-missing = Aucune hauteur de la classe que nomme la règle ne correspond au filtre pour : { $targets }. Mesurez et validez-en, choisissez cette classe, ou affichez tous les états.
sight-too-few = Trop peu de hauteurs pour le centile : { $targets }.
sight-too-few-of = { $target } ({ $reason })
sight-read = { $whose ->
    [class] de la classe que nomme chaque règle
    [chosen] des classes choisies, dans celle que nomme chaque règle
    [eyes] les yeux de la classe que nomme leur règle, les obstacles de tous les véhicules retenus, faute de classe connue
    [objects] les obstacles de la classe que nomme leur règle, les yeux de tous les véhicules retenus, faute de classe connue
   *[all] de tous les véhicules retenus
  }
sight-verdict-alike = { $case ->
    [mix] Avec les hauteurs de l’autre parc
    [study] Avec les hauteurs de l’étude
   *[survey] Avec les hauteurs du relevé
} (œil { $eye }, obstacle { $object }), la constante d’angle saillant est { $constant } au lieu de { $standard }, et K pour { $distance } est { $k } au lieu de { $k_standard }. L’écart de { $change } est dans l’intervalle à 95 % : le relevé ne donne aucune raison de construire autrement les angles saillants.
sight-verdict-shorter = { $case ->
    [mix] Avec les hauteurs de l’autre parc
    [study] Avec les hauteurs de l’étude
   *[survey] Avec les hauteurs du relevé
} (œil { $eye }, obstacle { $object }), la constante d’angle saillant est { $constant } au lieu de { $standard }, et K pour { $distance } est { $k } au lieu de { $k_standard }. K pourrait être plus petit de { $change }, donc les raccordements saillants plus courts ; sur un angle saillant construit selon la norme, la distance de visibilité est de { $seen }.
sight-verdict-longer = { $case ->
    [mix] Avec les hauteurs de l’autre parc
    [study] Avec les hauteurs de l’étude
   *[survey] Avec les hauteurs du relevé
} (œil { $eye }, obstacle { $object }), la constante d’angle saillant est { $constant } au lieu de { $standard }, et K pour { $distance } est { $k } au lieu de { $k_standard }. K devrait être plus grand de { $change }, donc les raccordements saillants plus longs ; sur un angle saillant construit selon la norme, la distance de visibilité n’est que de { $seen }.
sight-verdict-unknown = { $case ->
    [mix] Avec les hauteurs de l’autre parc
    [study] Avec les hauteurs de l’étude
   *[survey] Avec les hauteurs du relevé
} (œil { $eye }, obstacle { $object }), la constante d’angle saillant est { $constant } au lieu de { $standard }, soit K modifié de { $change }. Il n’y a pas d’intervalle ({ $reason }) : on ne sait pas si cet écart est significatif.
sight-cases-title = Angles saillants
sight-cases-distance = { $speed } : { $formula } = { $distance }, arrondi par excès à { $design }
sight-cases-note = Yeux : { NUMBER($eyes) }, obstacles : { NUMBER($objects) }, { $whose }. Les hauteurs sont les hauteurs vraies. Sous chaque valeur, son intervalle total à 95 %, qui comprend l’échantillonnage, les erreurs communes aux hauteurs (pose de la caméra, retrait moyen) et l’erreur aléatoire ; les erreurs de l’œil et de l’obstacle dues à la même pose de caméra comptent ensemble ; les hauteurs de la norme et les parts du parc sont supposées exactes. Les longueurs valent pour la différence de déclivités saisie ; la dernière colonne est la distance de visibilité sur un angle saillant construit selon la norme.
sight-interval = { $low } à { $high }
sight-no-interval = pas d’intervalle
sight-column-eye = Œil ({ $unit })
sight-column-object = Obstacle ({ $unit })
sight-column-constant = Constante ({ $unit })
sight-column-k = K ({ $unit } par %)
sight-column-length = Longueur minimale ({ $unit })
sight-column-seen = Visibilité sur le saillant de la norme ({ $unit })
sight-figure-title = K d’un angle saillant selon la vitesse de référence
sight-figure-says = K d’un angle saillant selon la vitesse de référence, avec les hauteurs de la norme et celles du relevé
sight-figure-note = K = S² / C à la distance de visibilité de chaque vitesse de référence, arrondie par excès comme dans les tables de conception (points). { $bands ->
    [0] Il n’y a pas d’intervalle, donc pas de bande.
   *[other] Bande : intervalle à 95 % ; là où l’on n’en voit pas, il est plus étroit que le trait.
}
sight-figure-x = Vitesse de référence ({ $unit })
sight-figure-y = K ({ $unit } par %)
sight-besides-title = Angle rentrant et virage, indépendants de la hauteur des yeux
sight-sag = Angle rentrant, à la lumière des projecteurs
sight-sag-words = K { $k } { $unit } par % ; longueur minimale { $length } { $case ->
    [within] (la distance de visibilité est comprise dans le raccordement)
    [beyond] (la distance de visibilité dépasse le raccordement)
   *[none] (ces déclivités sont éclairées sans raccordement)
}
sight-curve = Dégagement en virage
sight-curve-words = { $offset } de la trajectoire au masque, au milieu du virage
sight-curve-none = Le virage est trop serré pour cette distance : elle couvrirait plus d’un demi-cercle.
sight-besides-note = Le faisceau d’un projecteur monte de 1 degré. La hauteur des masques en bord de virage n’est pas prise en compte.

## Distance de visibilité : ce qui ne peut pas être calculé
sightdistance-heights = Les hauteurs des yeux doivent être supérieures à 0, celles des obstacles d’au moins 0, toutes inférieures à 10 m ; indiquez-les en mètres.
sightdistance-uncertainty = Une incertitude-type doit être de 0 à 10 m, et de 0 pour un obstacle sur la chaussée ; corrigez-la.
sightdistance-distance = Une distance de visibilité doit être supérieure à 0 et inférieure à 100 km, et une longueur d’au moins 0 ; indiquez des mètres.
sightdistance-difference = La différence des deux déclivités doit être supérieure à 0 et d’au plus 100 pour cent ; corrigez-la.
sightdistance-speed = { $speed_kmh } km/h n’est pas une vitesse de référence ; indiquez plus de 0 et au plus 300 km/h.
sightdistance-gradient = Un véhicule ne peut pas freiner sur une déclivité de { $gradient_percent } % ; indiquez au plus 25 %, et en descente moins que ne le permet la décélération.
sightdistance-reaction-deceleration = Le temps de réaction doit être de 0 ou plus et la décélération supérieure à 0 ; corrigez-les.
sightdistance-passing-speed = Il n’y a pas de distance de visibilité de dépassement à { $speed_kmh } km/h ; la table va de 30 à 130 km/h.
sightdistance-headlight = La hauteur du projecteur et la montée de son faisceau ne doivent être ni négatives, ni toutes deux nulles ; corrigez-les.
sightdistance-radius = Le rayon doit être supérieur à 0, et son virage contenir la distance et le dégagement ; corrigez-les.
sightdistance-shares = Les parts d’un parc doivent totaliser 100 % ; celles-ci totalisent { $total_percent } %. Corrigez-les.
sightdistance-share = « { $share } » n’est pas une part d’un parc ; écrivez la classe, deux-points et 0 à 100 pour cent (suv:40).
sightdistance-class-unseen = Le parc a une part de { $category }, dont le relevé n’a mesuré aucun véhicule ; mettez cette part à 0 ou mesurez-en.

## Catalogue : la page

catalogue-lead = Dimensions des modèles selon les constructeurs, chacune avec sa source, à comparer aux hauteurs et longueurs mesurées.
catalogue-loading = catalogue
catalogue-search = Rechercher par marque, modèle et année
catalogue-which = Quels modèles
catalogue-offered = proposés
catalogue-retired = retirés
catalogue-none = Aucun modèle
catalogue-none-found = Aucun modèle ne correspond. Cherchez avec moins de lettres.
catalogue-none-yet = Importez un CSV de modèles, ou ajoutez-en un à la main.
catalogue-model = Modèle
catalogue-years = Années
catalogue-category = Classe
catalogue-category-unknown = inconnue
catalogue-size-head = { $size } ({ $unit })
catalogue-height = Toit
catalogue-length = Longueur
catalogue-width = Largeur
catalogue-wheelbase = Empattement
catalogue-taillight = Feu arrière, bord inférieur
catalogue-headlight = Projecteur, bord inférieur
catalogue-u = u = { $u }
catalogue-u-of = { $size }, u
catalogue-source-of = { $size }, source
catalogue-source = Source des dimensions
catalogue-shown = { NUMBER($first) } à { NUMBER($last) } sur { NUMBER($total) }
catalogue-before = Précédents
catalogue-after = Suivants
catalogue-correct = Corriger
catalogue-correct-model = Corriger { $model }
catalogue-correct-title = Corriger un modèle
catalogue-correct-save = Enregistrer la correction
catalogue-retire = Retirer
catalogue-restore = Proposer à nouveau
catalogue-retire-done = { $retired ->
    [yes] { $model } est retiré du catalogue.
   *[no] { $model } est à nouveau proposé.
}
catalogue-add = Ajouter un modèle
catalogue-add-title = Ajouter un modèle
catalogue-add-save = Ajouter le modèle
catalogue-make = Marque
catalogue-model-name = Modèle
catalogue-year-from = Première année-modèle
catalogue-year-to = Dernière année-modèle
catalogue-needed = Obligatoire.
catalogue-year-problem = Saisissez quatre chiffres, par exemple 2019.
catalogue-number-problem = Saisissez un nombre.
catalogue-export = Exporter
catalogue-import = Importer un CSV
catalogue-import-title = Importer des modèles d’un CSV
catalogue-import-choose = Choisir un CSV de modèles
catalogue-import-drop = Déposez un CSV ici
catalogue-import-hint = Une ligne d’en-tête avec make et model ; dimensions avec leur unité dans l’en-tête (height_m, Length (mm)).
catalogue-import-looking = fichier
catalogue-import-unit = Unité des dimensions
catalogue-import-unit-header = selon les en-têtes, sinon mètres
catalogue-import-conflicts = Si le catalogue diffère
catalogue-import-keep = garder la valeur du catalogue
catalogue-import-replace = prendre la valeur du fichier
catalogue-import-columns = Colonnes du fichier
catalogue-import-in = en { $unit }
catalogue-import-left-out = ignorée
catalogue-import-some-left-out = { $count ->
    [one] Colonne non importée : { $columns }. Choisissez sa signification s’il s’agit d’une dimension, d’une année ou d’une incertitude.
   *[other] Colonnes non importées : { $columns }. Choisissez leur signification s’il s’agit de dimensions, d’années ou d’incertitudes.
}
catalogue-import-lines = Lignes à examiner
catalogue-import-line = Ligne
catalogue-import-what = Action
catalogue-import-why = Motif
catalogue-import-store = { $count ->
    [0] Rien à enregistrer
    [one] Enregistrer { NUMBER($count) } modèle
   *[other] Enregistrer { NUMBER($count) } modèles
}
catalogue-import-done = Modèles ajoutés : { NUMBER($added) }, mis à jour : { NUMBER($updated) }.
catalogue-change-new = nouveau
catalogue-change-update = complété
catalogue-change-same = inchangé
catalogue-change-conflict = en conflit
catalogue-change-duplicate = en double dans le fichier
catalogue-change-refused = refusé
catalogue-unit-m = mètres
catalogue-unit-cm = centimètres
catalogue-unit-mm = millimètres
catalogue-unit-ft = pieds
catalogue-unit-in = pouces

## Catalogue : ce qu’un import dit d’une ligne, et ce qui ne peut pas être stocké
catalogue-make-and-model = Saisissez la marque et le modèle.
catalogue-too-long = Une marque a au plus { $most_make } caractères et un modèle { $most_model } ; raccourcissez.
catalogue-years-reversed = La dernière année précède la première ; inversez-les.
catalogue-sizes-contradict = { $column } vaut { $value } et { $other } vaut { $large }, ce qui n’est pas plausible pour un véhicule ; corrigez l’une des deux valeurs.
catalogue-control-characters = Une marque, un modèle ou une source contient un caractère qui ne peut être affiché ; saisissez-le à nouveau.
catalogue-say-the-columns = { $name } n’a pas de colonne { $missing } ; attribuez-lui l’une de ses colonnes, ou nommez-la ainsi en première ligne.
catalogue-no-rows = { $name } a un en-tête et aucune ligne de modèle en dessous ; ajoutez-en une.
catalogue-column-twice = Les colonnes { $first } et { $second } sont toutes deux { $field } ; choisissez celle qui compte.
catalogue-size-impossible = { $column } vaut { $value }, ce qui n’est pas plausible pour un véhicule ; indiquez-le en mètres, de { $low } à { $high }.
catalogue-size-unit = { $column } vaut { $value }, ce qui n’est pas plausible en mètres ; en { $unit } ce serait { $metres } m. Donnez des mètres, ou indiquez l’unité.
catalogue-u-impossible = { $column } vaut { $value } m, ce qui n’est pas plausible pour l’incertitude-type de cette dimension ; indiquez son unité, ou donnez des mètres, de 0 à { $most }.
catalogue-unit-doubtful = { $column } : la moitié de ses valeurs sont { $middle } ou plus, ce qui n’est pas plausible en { $unit } ; elles ressemblent à des { $other }. Rien n’a été enregistré. Indiquez l’unité { $sign }, ou convertissez le fichier.
catalogue-there-already = { $make } { $model } ({ $year }) est déjà dans le catalogue ; corrigez plutôt cette ligne.
catalogue-changed-meanwhile = { $make } { $model } a été modifié entre-temps ; contrôlez-le et refaites votre modification.
catalogue-no-such-field = Le catalogue n’a pas de champ « { $field } » ; utilisez l’un de { $known }.
catalogue-column-choice = « { $column } » n’attribue aucune colonne ; écrivez le champ, un signe égal et l’en-tête (height_m=Roof).
catalogue-duplicate = Même modèle que la ligne { $line } ; ignorée.
catalogue-duplicate-differs = Même modèle que la ligne { $line } avec d’autres valeurs ({ $differences }) ; ignorée. Gardez l’une des deux.
catalogue-conflict-keep = { $differences } ; la valeur du catalogue est gardée.
catalogue-conflict-replace = { $differences } ; la valeur de cette ligne la remplace.
catalogue-differs = { $here } ici, { $there } là-bas
catalogue-fills-in = Complète { $columns }.

studies-fleet-header = { $path } demande une colonne category (ou lighting, stratum, site), ou les deux colonnes variable et class, et une colonne share ou registrations ; ajoutez-les.
studies-fleet-variable = { $path }, ligne { $row } : un parc ne se divise pas selon { $cell } ; utilisez l’un de { $known }.
studies-fleet-class-twice = { $path }, ligne { $row } : { $name } est là deux fois ; gardez une seule ligne.
studies-fleet-empty = { $path } n’a pas de ligne ; donnez une ligne par classe.
studies-shares-sum = { $path } : les parts de { $variable } totalisent { $total }, non 1 ; corrigez-les, ou donnez à la place registrations.
studies-registrations-sum = { $path } : { $first } totalise { $first_sum } véhicules et { $other } { $other_sum } ; les deux doivent décrire le même parc.
studies-sites-header = { $path } demande les colonnes site et stratum ; ajoutez-les.
studies-sites-there-differ = { $path }, ligne { $row } : la strate { $stratum } a un autre sites_there plus haut ; écrivez le même nombre, ou aucun, dans chacune de ses lignes.
studies-traffic-of-some = { $path } : traffic n’est là que pour certains sites, ou vaut 0 ; donnez-le pour tous les sites ou pour aucun.
studies-not-a-count = { $path }, ligne { $row } : { $name } vaut { $cell }, qui n’est pas un nombre entier de 1 ou plus ; corrigez-le ou laissez-le vide.
studies-not-an-amount = { $path }, ligne { $row } : { $name } vaut { $cell }, qui n’est pas un nombre de 0 ou plus ; corrigez-le.
studies-no-package-there = { $place } n’est pas une archive et n’en contient pas ; nommez des dossiers ou ZIP exportés, ou un dossier qui en contient.
studies-package-unverified = { $place } échoue au contrôle et ne peut pas servir à une étude : { $problem }
studies-package-lacks-column = { $place } (version { $version }) n’a pas la colonne { $column } de { $table }, dont une étude a besoin ; exportez à nouveau son relevé.
studies-package-word-unknown = { $place } (version { $version }) contient, dans la colonne { $column } de { $table }, « { $word } », que cette version ne connaît pas ; utilisez la version indiquée ou une version plus récente.
studies-package-without-parquet = { $place } a été faite par une version antérieure, sans Parquet ; exportez à nouveau son relevé.
studies-survey-without-poses = { $place } n’a pas de pose de la caméra, donc pas de hauteur ; omettez-le, ou calculez la pose de ses enregistrements (et exportez à nouveau une archive).
studies-same-survey-twice = { $first } et { $second } sont des archives du même relevé ; gardez la plus récente.
studies-no-height-counts = Aucun des relevés n’a de hauteur validée qui compte ; vérifiez des mesures (et exportez à nouveau une archive).
studies-class-unknown = Le parc a { $variable } { $name }, que Sightline ne connaît pas ; utilisez { $known }.
studies-class-never-seen = Le parc a { $variable } { $name }, qu’aucun relevé ne contient ; omettez-le et faites totaliser 1 aux autres parts, ou mesurez-en.
studies-fleet-lacks-class = Les relevés contiennent { NUMBER($count) } véhicules de { $variable } { $name }, que le parc n’a pas ; ajoutez-lui une ligne (0 pour les exclure).
studies-site-missing = Le tableau des sites n’a pas de ligne pour { $site } ; ajoutez-la.
studies-too-many-sites = La strate { $stratum } a { NUMBER($count) } sites ici, mais sites_there indique { $there } ; corrigez-le.
studies-needs-a-name = Une étude doit avoir un nom ; indiquez-le.
studies-needs-each-survey = Vous ne voyez pas actuellement chaque relevé de cette étude ; demandez à un gestionnaire de ces relevés de vous ajouter.
studies-open-needs-managers = Vous ne gérez pas { $name } ; seule une personne qui gère chacun des relevés d’une étude peut la montrer à tous. Demandez à un gestionnaire de { $name }.
studies-has-no-survey = L’étude n’a pas de relevé ; ajoutez-en au moins un.
studies-goal-of-study = { $goal } m n’est pas une U95 entre 0 et 1 m ; 0,010 m font 10 mm.
studies-survey-stands-twice = { $name } figure deux fois dans l’étude ; gardez-le une seule fois.
studies-no-year = { $year } n’est pas une année possible pour { $name } ; corrigez-la, ou laissez vide.
studies-two-strata = Le site { $site } est dans les strates { $first } et { $second } ; donnez-lui-en une seule, dans tous ses relevés et dans le tableau des sites.
studies-site-without-stratum = Le site { $site } n’a pas de strate, alors que d’autres en ont ; donnez-en une à chaque site, ou à aucun.
studies-changed-meanwhile = { $name } a modifié cette étude le { $when }. Rechargez-la et refaites votre modification.
studies-goal-no-length = --goal { $goal } n’est pas une U95 en mètres entre 0 et 1 ; 0,010 fait 10 mm.
studies-compared-with-itself = { $name } ne peut pas être comparée à elle-même ; choisissez une autre étude.
studies-compared-without-figures = { $name } n’a pas été calculée ; calculez-la d’abord.
studies-fleet-two-amounts = { $path } a une colonne share et une colonne registrations ; gardez celle qui compte.
studies-registrations-of-nobody = { $path } : la somme de { $variable } est de 0 véhicule ; indiquez combien il y en a.
studies-output-in-package = { $place } est l’archive d’un relevé, ou se trouve dans une archive ; nommez pour l’étude un dossier à elle.
traffic-duration-twice = { $path } indique lui-même sa durée ; omettez --duration.
traffic-no-duration-inside = { $path } n’indique pas sa durée ; écrivez-le à nouveau avec sightline linescan --json.
traffic-own-lanes = Les véhicules de { $name } ont leurs propres voies ({ $lanes }) ; omettez --lane.
traffic-no-duration = { $path } contient des lignes de sightline stream, qui n’indiquent pas la durée ; indiquez --duration en secondes.
traffic-no-recording = { $path } n’est pas une sortie de sightline linescan --json ni de sightline stream ; indiquez l’une d’elles.
traffic-file-too-large = { $path } dépasse { $most_gb } Go ; ajoutez l’enregistrement par parties.
traffic-cannot-read = { $path } est illisible ({ $strerror }) ; indiquez la sortie de sightline linescan --json ou de sightline stream.
traffic-vehicle-without = Le véhicule { $vehicle } de { $path } n’a pas de { $column } lisible ; écrivez-le à nouveau avec sightline linescan --json.
traffic-number-twice = { $path } a deux fois le véhicule { $vehicle } ; donnez un enregistrement par fichier.
traffic-outside-recording = Le véhicule { $vehicle } de { $path } est passé de { $front_s } s à { $rear_s } s, hors des { $duration_s } s de l’enregistrement ; corrigez --duration, ou écrivez à nouveau le fichier.
import-videos-or-folder = Nommez des vidéos, ou un dossier avec --watch, pas les deux ; voyez sightline import --help.
import-no-token = Il faut un jeton : créez-en un dans Compte avec lire et envoyer, et mettez-le dans SIGHTLINE_TOKEN.
import-no-address = « { $url } » n’est pas une adresse de Sightline ; écrivez-la http://name:8000.
import-no-answer = { $url } ne répond pas ; vérifiez l’adresse, et que le serveur est en marche.
import-no-sightline = { $url } a répondu avec le statut { NUMBER($status, useGrouping: 0) } mais pas comme Sightline ; vérifiez l’adresse.
import-server-said = Le serveur a répondu : { $sentence }.
import-no-such-survey = Il n’y a pas de relevé « { $survey } » visible pour vous ; les vôtres sont : { $names }.
import-survey-name-twice = Plusieurs relevés s’appellent « { $survey } » ; donnez le numéro de l’un : { $numbers }.
import-no-such-file = { $name } n’est pas un fichier ; vérifiez le nom.
import-no-such-folder = { $name } n’est pas un dossier ; nommez-en un qui existe.
import-not-a-video = { $name } n’est pas une vidéo d’après son nom ; les vidéos finissent par { $suffixes }.
import-empty-file = { $name } est vide ; indiquez le fichier que la caméra a écrit.
import-changed-meanwhile = { $name } a été modifié pendant son envoi ; supprimez son enregistrement, et importez-le à nouveau quand il est terminé.
import-cannot-be-read = { $name } a été envoyé, mais il est illisible : { $reason }.
import-passes-not-found = { $name } a été importé, mais ses passages n’ont pas été trouvés : { $reason }.
traffic-recording-there = { $name } est déjà dans l’archive de trafic (site { $site }, { $day }) ; retirez-le d’abord avec : sightline traffic remove
traffic-other-zone = Le site { $site } est à l’heure de { $there }, non de { $zone } ; indiquez ce fuseau, ou un autre site.
traffic-overlap = { $name } et { $other }, qui est dans l’archive de trafic, ont tous deux observé cette voie de { $site } de { $start } à { $end } ; corrigez --start, ou nommez la voie avec --lane.
traffic-no-name = « { $name } » ne peut pas nommer ici { $what ->
    [site] un site
    [lane] une voie
   *[other] { $what }
} ; utilisez au plus { $most } lettres, chiffres, espaces et - _ . sans point au début.
traffic-no-such-recording = { $path } n’a pas d’enregistrement { $name } ; donnez le nom de son fichier ou le début de son SHA-256.
traffic-several-recordings = { $path } a plusieurs enregistrements que { $name } peut désigner ; donnez le début du SHA-256 de l’un.
traffic-no-archive = { $path } ne contient pas d’archive de trafic ; créez-en une avec : sightline traffic add
traffic-being-changed = { $path } est en cours de modification par un autre processus ; réessayez quand il a fini.
traffic-cannot-write = Impossible d’écrire { $path } ({ $strerror }) ; choisissez un autre dossier, ou libérez de la place.
traffic-no-u-start = --u-start { $u_start_s } n’est pas une incertitude-type en secondes ; indiquez 0 ou plus.
traffic-duration-not-positive = --duration { $duration_s } n’est pas un temps en secondes supérieur à 0 ; corrigez-le.
traffic-no-minutes = --minutes { $minutes } ne divise pas un jour ; utilisez 1, 5, 15, 30, 60 ou un autre diviseur.
traffic-no-percents = --percentile { $text } doit donner des nombres différents, supérieurs à 0 et inférieurs à 100, comme 15,50,85.
traffic-no-limits = --lengths { $text } doit donner des longueurs croissantes en mètres entre 0 et 100, comme 6,12.
traffic-no-numbers = { $option } { $text } contient autre chose que des nombres ; séparez les nombres par des virgules.
traffic-no-day = { $option } { $text } n’est pas un jour ; écrivez-le 2026-05-04.
traffic-days-turned = --to { $last } précède --from { $first } ; inversez-les.
traffic-no-such-site = L’archive de trafic n’a pas de site { $site } ; elle a { $there }.
commands-errors-several-targets = Les hauteurs sont de { $targets } ; utilisez --by target pour comparer chacune à ses références.
commands-errors-unknown-word = Ligne { $line } : { $column } est « { $word } » ; utilisez l’un de ces mots : { $known }.
commands-compare-two-values = --compare { $text } demande --by et deux valeurs différentes de sa colonne, comme --by year --compare 2020,2026.
commands-compare-value-unknown = Aucune ligne avec une hauteur n’a { $name } dans { $by } ; comparez deux valeurs parmi { $known }.

## La page que porte une archive (index.html) : lue sans serveur ; elle n’a pas de code commun avec ce qui a mesuré

opened-reading = Lecture de l’archive…
opened-unreadable = Cette page ne peut pas lire l’archive qu’elle porte. Utilisez un navigateur de 2023 ou plus récent, ou lancez sightline verify.
opened-broken = Cette page s’est arrêtée à cause d’une erreur ; elle n’affiche donc aucun résultat. Lancez sightline verify pour contrôler le fichier.
opened-made-with = Fait avec Sightline { $version }.
opened-only = Cette archive est limitée. Statistiques, figures et rapport ne portent que sur : { $only }. Les autres véhicules du relevé figurent dans les tableaux et sont exclus des résultats.
opened-report = Rapport (PDF)
opened-measurements = Mesures
opened-figures = Figures
opened-tables = Tableaux
opened-tables-lead = Les nombres sont arrondis ici ; les fichiers contiennent toutes les décimales. datapackage.json décrit chaque colonne, en anglais.
opened-table = { $table ->
    [survey] le relevé, en une ligne
    [vehicles] passages et véhicules
    [recordings] fichiers vidéo
    [poses] poses de la caméra
    [insets] retraits par défaut du relevé
    [selection] limites de cette archive
    [people] personnes nommées dans les autres tableaux
    [exclusions] mesures exclues des résultats, avec le motif
    [response] issue des passages
    [error_table] erreurs des toits validés (hauteur mesurée moins hauteur du constructeur)
    [agreement] limites de concordance, et régression de l’erreur sur la hauteur
    [corrections] effet de chaque correction sur les hauteurs
    [percentiles] centiles des hauteurs, avec intervalles à 95 %
    [total_uncertainty] grandeurs des hauteurs vraies, avec intervalles totaux
    [same_rule] conclusion pour chaque norme
    [shares] part des hauteurs inférieures à la valeur de chaque norme
   *[lateral_positions] positions latérales des véhicules
}
opened-checks = Contrôles
opened-sizes = Tailles
opened-checking = Contrôle de l’archive…
opened-is-fine = Les contrôles de cette page n’ont trouvé aucune contradiction.
opened-is-wrong = Cette archive a été modifiée après sa création.
opened-failed = L’archive n’a pas pu être lue en entier : { $words }.
opened-heights-agree = { $count ->
    [one] { NUMBER($count) } hauteur a été recalculée à partir de ses pointés et concorde.
   *[other] { NUMBER($count) } hauteurs ont été recalculées à partir de leurs pointés et concordent.
  } La plus grande différence est de { NUMBER($off_um, maximumFractionDigits: 2) } µm ; les tableaux sont écrits au micromètre.
opened-heights-refused = { $count ->
    [one] { NUMBER($count) } n’a pas été calculée : voyez sa ligne.
   *[other] { NUMBER($count) } n’ont pas été calculées : voyez leurs lignes.
  }
opened-heights-differ = { $count ->
    [one] { NUMBER($count) } mesure diffère de ce que donnent ses pointés : { $named }.
   *[other] { NUMBER($count) } mesures diffèrent de ce que donnent leurs pointés : { $named }.
  }
opened-chain-whole = { $count ->
    [one] La chaîne d’audit de { NUMBER($count) } événement est intacte.
   *[other] La chaîne d’audit de { NUMBER($count) } événements est intacte : chaque événement correspond à son empreinte et suit le précédent.
  }
opened-chain-broken = La chaîne d’audit est rompue à l’événement { $number }.
opened-chain-absent = La chaîne d’audit n’a pas été contrôlée : audit.js ne se trouve pas à côté de cette page, ou la chaîne est trop grande pour une page. Déposez ici le ZIP ou le dossier de l’archive, ou utilisez sightline verify.
opened-seal-none = La chaîne d’audit ne finit pas par le sceau d’une archive.
opened-seal-chain = La chaîne d’audit avant le sceau n’est pas celle que nomme le sceau.
opened-seal-holds = Les { NUMBER($count) } fichiers que porte cette page concordent avec le sceau.
opened-seal-wrong = Fichiers qui ne concordent pas avec le sceau : { $named }.
opened-rows-agree = Chaque mesure concorde avec son événement d’audit.
opened-rows-differ = { $count ->
    [one] { NUMBER($count) } mesure diffère de son événement d’audit : { $named }.
   *[other] { NUMBER($count) } mesures diffèrent de leurs événements d’audit : { $named }.
  }
opened-poses-agree = Chaque pose de la caméra concorde avec son événement d’audit.
opened-poses-differ = Poses de la caméra qui diffèrent de leurs événements d’audit : { $named }.
opened-signature-holds = Signé le { $at } avec la clé { $key }… : comparez-la à celle qu’affiche l’installation.
opened-signature-wrong = La signature ne vaut pas pour la fin de cette chaîne.
opened-signature-unknown = La signature n’a pas été contrôlée, car ce navigateur ne prend pas en charge Ed25519. Utilisez sightline verify.
opened-folder-choose = Contrôlez aussi les fichiers : déposez le ZIP ou le dossier de l’archive n’importe où sur cette page, ou choisissez-le ici. Rien ne quitte cet ordinateur.
opened-folder-folder = Le dossier où se trouve cette page
opened-folder-zip = Ou le ZIP de l’archive
opened-folder-unreadable = Les fichiers n’ont pas été contrôlés : la sélection n’est pas une archive complète. Reprenez le ZIP, ou choisissez le dossier.
opened-folder-checking = Contrôle des fichiers…
opened-folder-fine = Les { NUMBER($count) } fichiers de l’archive ({ NUMBER($mb, maximumSignificantDigits: 2) } Mo) concordent tous avec le sceau.
opened-folder-changed = Modifiés après l’export : { $named }.
opened-folder-missing = Manquent dans l’archive : { $named }.
opened-folder-strange = Hors de l’archive : { $named }.
opened-what-title = Ce qui est contrôlé, et où
opened-what-here = Ici, d’après les copies des tableaux que porte cette page : chaque hauteur en vigueur à partir des pointés, de l’objectif et de la pose de la caméra, par un calcul propre à cette page ; U95 comme 1,96 u et u comme racine de la somme des carrés de son bilan ; la chaîne d’audit avec son sceau et sa signature ; chaque mesure et chaque pose de la caméra par rapport à son événement d’audit.
opened-what-folder = Seulement une fois le dossier choisi ou le ZIP déposé : si les fichiers de l’archive (vues, figures, rapport, tableaux) concordent avec le sceau. Un navigateur ne laisse pas une page lire d’autres fichiers sans le demander.
opened-what-verify = Seulement par sightline verify : révisions antérieures et répétitions, composantes des bilans, décisions par rapport aux vérifications, véhicules, balayages, statistiques, figures et rapport refaits, Parquet par rapport au CSV.
opened-what-page = Une page peut être falsifiée en entier, et dirait alors ce que veut le faussaire. Si l’enjeu le demande, lancez sightline verify avec la clé qu’affiche l’installation.
opened-measurements-none = Aucune mesure dans cette archive.
opened-figures-none = Aucune figure : trop peu de mesures validées.
opened-left-out = Trop volumineux pour cette page, donc ni affichés ni contrôlés ici : { $named }. Utilisez sightline verify.
opened-table-empty = Aucune ligne.
opened-table-cut = Les { NUMBER($shown) } premières lignes sur { NUMBER($count) } ; le fichier les a toutes.
opened-sizes-total = { $files ->
    [one] { NUMBER($files) } fichier
   *[other] { NUMBER($files) } fichiers
}, { NUMBER($mb, maximumSignificantDigits: 3) } Mo, outre cette page, la description, la chaîne d’audit et la liste des sommes.
opened-size-top = { $files ->
    [one] { NUMBER($files) } fichier
   *[other] { NUMBER($files) } fichiers
} à la racine, { NUMBER($mb, maximumSignificantDigits: 2) } Mo
opened-size = { $folder } { $files ->
    [one] { NUMBER($files) } fichier
   *[other] { NUMBER($files) } fichiers
}, { NUMBER($mb, maximumSignificantDigits: 2) } Mo
opened-filter = Afficher
opened-filter-all = toutes
opened-filter-differs = celles qui diffèrent
opened-filter-stale = celles qui sont périmées
opened-stale-count = { $count ->
    [one] { NUMBER($count) } hauteur est périmée : elle découle d’une pose de la caméra, d’un retrait ou d’un côté du conducteur modifié après son calcul. Elle est incluse sans changement.
   *[other] { NUMBER($count) } hauteurs sont périmées : elles découlent d’une pose de la caméra, d’un retrait ou d’un côté du conducteur modifié après leur calcul. Elles sont incluses sans changement.
}
opened-stale-mark = périmée
opened-stale = { $cause ->
    [pose] Périmée : la pose de la caméra a été modifiée après son calcul.
    [inset] Périmée : le retrait a été modifié après son calcul.
   *[side] Périmée : le côté du conducteur a été modifié après son calcul.
}
opened-before = Précédent
opened-after = Suivant
opened-range = { NUMBER($from) } à { NUMBER($to) } sur { NUMBER($count) }
opened-target-roof = Toit
opened-target-driver_eye = Œil du conducteur
opened-target-taillight = Feu arrière
opened-target-headlight = Projecteur
opened-target-other = Autre
opened-verdict-accepted = validée
opened-verdict-fixed = corrigée
opened-verdict-rejected = rejetée
opened-verdict-unreviewed = non vérifiée
opened-withdrawn = retirée
opened-outside = { $verdict } ; hors des limites
opened-column-id = N°
opened-column-target = Cible
opened-column-package = Hauteur dans l’archive
opened-column-here = Calculée ici
opened-column-review = Vérification
opened-height = { $height_m } ± { $U95_m } m
opened-height-here = { $height_m } m
opened-height-none = pas de hauteur
opened-refused-pose = non calculée : sa pose de la caméra n’est pas dans l’archive
opened-refused-form = non calculée : il manque certaines de ses images dans le tableau
opened-one = Mesure { $id } : { $target }
opened-crops-none = Aucune image de cette mesure dans cette archive.
opened-crops-outside = Hors des limites de cette archive ({ $only }) : elle n’a pas d’image ici et est exclue des résultats.
opened-crop = Image { $frame } avec les deux points
opened-differs = Diffère de ce que donnent les pointés : { $named }.
opened-pair-package = Hauteur dans l’archive, m
opened-pair-here = Calculée dans cette page
opened-pair-off = Différence
opened-nanometres = { $off_nm } nm
opened-pair-contact = Contact du pneu, px
opened-pair-target = Cible, px
opened-pair-inset = Retrait, m
opened-pair-frame = Enregistrement et image
opened-pair-pose = Pose de la caméra
opened-pair-u = u de { $source }, m

## Ce que signifient les colonnes qu’explique la page d’une archive

column-measurements-id = mesure (une suite de révisions)
column-measurements-revision = numéro de la révision en vigueur, à partir de 1
column-measurements-vehicle-id = véhicule mesuré
column-measurements-recording-id = enregistrement dans lequel les points ont été placés
column-measurements-target = ce qui a été mesuré
column-measurements-frame = numéro de l’image : la n-ième image décodée, à partir de 0
column-measurements-pts = horodatage de présentation de cette image, dans la base de temps du flux
column-measurements-time-s = instant de cette image depuis le début du flux
column-measurements-frame-crc32 = CRC-32 de la luminance décodée de cette image : la preuve de ce qui a été pointé
column-measurements-contact-x-px = contact du pneu avec la chaussée, x vers la droite ; (0, 0) est le centre du pixel en haut à gauche
column-measurements-contact-y-px = contact du pneu avec la chaussée, y vers le bas ; (0, 0) est le centre du pixel en haut à gauche
column-measurements-target-x-px = la cible, x vers la droite ; (0, 0) est le centre du pixel en haut à gauche
column-measurements-target-y-px = la cible, y vers le bas ; (0, 0) est le centre du pixel en haut à gauche
column-measurements-sigma-px = incertitude-type de chaque coordonnée de chaque pointé
column-measurements-made = comment les points ont été placés sur `frame` : clicked : à la main (le contact peut être proposé là où aucune cible ne l’était) ; snapped : le contact est passé d’un pointé au pneu trouvé à cet endroit ; confirmed : tels que proposés ; moved : à partir de points proposés ou trouvés (contact ou cible), dont une personne a placé au moins un
column-measurements-snapped-from-x-px = où une personne a cliqué avant que le contact ne passe au pneu trouvé là, x vers la droite ; (0, 0) est le centre du pixel en haut à gauche
column-measurements-snapped-from-y-px = où une personne a cliqué avant que le contact ne passe au pneu trouvé là, y vers le bas ; (0, 0) est le centre du pixel en haut à gauche
column-measurements-proposal = si le contact et la cible étaient proposés sur `frame` lors de la mesure : shown : affichés ; withheld : non montrés, le véhicule ayant été tiré au sort pour une mesure libre ; vide : l’un des deux n’était pas proposé
column-measurements-proposed-contact-x-px = où le contact était proposé, x vers la droite ; ne compte pour aucune hauteur ; (0, 0) est le centre du pixel en haut à gauche
column-measurements-proposed-contact-y-px = où le contact était proposé, y vers le bas ; ne compte pour aucune hauteur ; (0, 0) est le centre du pixel en haut à gauche
column-measurements-proposed-target-x-px = où la cible était proposée, x vers la droite ; ne compte pour aucune hauteur ; (0, 0) est le centre du pixel en haut à gauche
column-measurements-proposed-target-y-px = où la cible était proposée, y vers le bas ; ne compte pour aucune hauteur ; (0, 0) est le centre du pixel en haut à gauche
column-measurements-pose-id = pose de la caméra utilisée
column-measurements-calibration-id = étalonnage dont vient cette pose
column-measurements-inset-m = retrait : distance du plan vertical passant par le contact à la cible, selon l’axe Y de la route
column-measurements-u-inset-m = incertitude-type du retrait (k = 1)
column-measurements-side = d’un œil : côté du véhicule, vu de la caméra, où est assis le conducteur
column-measurements-side-from = origine du côté : indiqué pour ce véhicule, son sens, ou la voie la plus proche de la caméra
column-measurements-inset-from = si le retrait est celui du relevé ou propre à cette mesure
column-measurements-frames = nombre d’images sur lesquelles les points ont été placés, ou suivis tout au long d’un passage
column-measurements-frame-n = numéro de l’image { $frame } sur laquelle les points ont été placés
column-measurements-contact-n-x-px = le même contact du pneu sur l’image { $frame } de la mesure, x
column-measurements-contact-n-y-px = le même contact du pneu sur l’image { $frame } de la mesure, y
column-measurements-target-n-x-px = la même cible sur l’image { $frame } de la mesure, x
column-measurements-target-n-y-px = la même cible sur l’image { $frame } de la mesure, y
column-measurements-followed = d’un passage entier : JSON des points suivis à partir de ceux de `frame` (docs/formats.md) ; height_m est alors la hauteur qui résulte de tous
column-measurements-solved-inset-m = retrait trouvé d’après plusieurs images ou un passage entier ; inset_m ne sert alors pas à height_m, sauf, d’un passage entier, comme connaissance préalable
column-measurements-u-solved-inset-m = incertitude-type du retrait trouvé (k = 1)
column-measurements-height-m = hauteur de la cible au-dessus de la chaussée selon sa normale, corrigée du retrait
column-measurements-uncorrected-height-m = hauteur d’après la première image avec un retrait de 0 (hypothèse de l’article)
column-measurements-u-height-m = incertitude-type de height_m (k = 1)
column-measurements-u95-height-m = demi-largeur de l’intervalle à 95 % de height_m
column-measurements-x-m = contact le long de la route, depuis l’origine de la pose (X)
column-measurements-y-m = contact en travers de la route, en s’éloignant de la caméra (Y)
column-measurements-u-clicks-m = composante de u_height_m due aux pointés, qu’aucune autre hauteur ne partage
column-measurements-u-by-inset-m = composante de u_height_m due au retrait supposé ; la composante restante est celle de la pose de la caméra
column-measurements-distance-m = distance du centre de la caméra au contact
column-measurements-status = s’il y a une hauteur
column-measurements-reason = pourquoi il n’y a pas de hauteur
column-measurements-reason-code = le motif par code et valeurs (JSON)
column-measurements-flags = avertissements sur cette hauteur, séparés par des points-virgules
column-measurements-flags-code = flags par code et valeurs (JSON)
column-statistics-warning-code = avertissement par code et valeurs (JSON)
column-statistics-words-code = texte par code et valeurs (JSON)
column-measurements-code-version = version du programme qui a calculé la hauteur
column-measurements-created-by-id = qui a fait la révision : placé les points, retiré ou rétabli la mesure ; pour une révision recalculée, comme la précédente
column-measurements-operator-id = qui a placé les points en vigueur, l’auteur de la première révision qui les a : l’opérateur de toutes les statistiques
column-measurements-clicked-at = quand les points en vigueur ont été placés : le jour de mesure
column-measurements-created-at = quand la révision a été enregistrée
column-measurements-withdrawn = true si la mesure a été retirée
column-measurements-computing-id = le recalcul dont vient cette révision, avec les pointés de la précédente
column-measurements-verdict-of-revision = révision antérieure dont la décision vaut aussi pour celle-ci : recalculée, elle n’a pas bougé de plus que son u, ou ses points ont été remis où ils étaient
column-measurements-filmed-at = quand cette image a été filmée, à l’heure du lieu (ISO 8601 avec décalage) : started_at de son enregistrement et time_s ; rien tant que personne n’a confirmé ce début
column-measurements-verdict = état de la vérification de cette révision
column-measurements-review-reason = le motif du vérificateur
column-measurements-reviewer-id = qui a vérifié
column-measurements-reviewed-at = quand la vérification a eu lieu
column-measurements-verdict-by = si un vérificateur a jugé cette mesure elle-même, ou son lot d’après un échantillon
column-measurements-lot-id = d’une décision par lot : le lot
column-measurements-out-of-date = pourquoi la hauteur est périmée, séparés par des points-virgules : pose, inset ou side si elle résulte d’une pose d’un autre enregistrement, d’un autre retrait usuel ou d’un autre côté du conducteur que ceux de cette archive ; vide : elle ne l’est pas. Recalculez les hauteurs dans le relevé et exportez-le à nouveau
column-budget-measurement-id = mesure
column-budget-source = source d’incertitude
column-budget-u-m = sa contribution à l’incertitude-type de la hauteur
column-survey-id = relevé, dans la base de données dont il vient
column-survey-name = nom du relevé
column-survey-site = lieu où il a été filmé ; une étude prend les relevés d’un même site comme une grappe
column-survey-description = description du relevé
column-survey-simulated = true : inventé ; aucune de ses valeurs ne décrit de vraies routes
column-survey-latitude-deg = latitude (WGS84), nord positif
column-survey-longitude-deg = longitude (WGS84), est positif
column-survey-road-class = classe de la route, en toutes lettres
column-survey-lane = voie mesurée, en toutes lettres
column-survey-travel-direction = sens de circulation, en toutes lettres
column-survey-speed-limit-mps = vitesse limite
column-survey-street-lamps = si la route a un éclairage public
column-survey-time-zone = fuseau horaire du site (IANA), proposé pour les enregistrements
column-vehicles-id = véhicule
column-vehicles-number = son numéro dans le relevé
column-vehicles-recording-id = enregistrement dans lequel il passe
column-vehicles-first-frame = première image du passage
column-vehicles-last-frame = dernière image du passage
column-vehicles-best-frame = image proposée pour la mesure
column-vehicles-make = constructeur
column-vehicles-model = modèle
column-vehicles-year = année-modèle
column-vehicles-model-chosen-by = size : le modèle a été choisi parce qu’il correspond à ce qui a été mesuré, aucune hauteur connue du véhicule n’est donc une référence ; seen : il a ensuite été reconnu sur le véhicule ; vide : ni l’un ni l’autre
column-vehicles-model-sizes = d’un modèle choisi par ses dimensions : lesquelles, séparées par des espaces
column-vehicles-category = type de carrosserie
column-vehicles-manufacturer-height-m = hauteur hors tout du constructeur
column-vehicles-u-manufacturer-height-m = incertitude-type de cette hauteur (k = 1)
column-vehicles-height-source = d’où vient cette hauteur
column-vehicles-known-driver-eye-m = hauteur de l’œil de son conducteur connue avant la mesure
column-vehicles-known-taillight-m = hauteur de son feu arrière connue avant la mesure
column-vehicles-known-headlight-m = hauteur de son projecteur connue avant la mesure
column-vehicles-known-other-m = hauteur de son repère connue avant la mesure
column-vehicles-check-target = un jalon à repères, ou une voiture aux hauteurs mesurées au mètre ruban, pour contrôler la mesure : lignes propres dans errors_by_target.csv, aucun véhicule du trafic
column-vehicles-lighting = luminosité lors du passage
column-vehicles-direction = sens de circulation sur l’image
column-vehicles-driver-side = côté du conducteur tel qu’indiqué, vu de la caméra ; aucun s’il résulte du sens
column-vehicles-roof-not-visible = pourquoi le toit de ce véhicule ne peut pas être mesuré ; rien s’il peut l’être
column-vehicles-driver-eye-not-visible = pourquoi l’œil du conducteur de ce véhicule ne peut pas être mesuré ; rien s’il peut l’être
column-vehicles-taillight-not-visible = pourquoi le feu arrière de ce véhicule ne peut pas être mesuré ; rien s’il peut l’être
column-vehicles-headlight-not-visible = pourquoi le projecteur de ce véhicule ne peut pas être mesuré ; rien s’il peut l’être
column-vehicles-first-s = temps de first_frame depuis la première image de son enregistrement, selon la table des images ; aucun si celle-ci manque
column-vehicles-filmed-at = quand sa première image a été filmée, à l’heure du lieu (ISO 8601 avec décalage) : first_s après started_at de son enregistrement ; rien tant que personne n’a confirmé ce début
column-vehicles-in-sample = si la règle de sampling.csv le retient
column-vehicles-counts = si ses hauteurs comptent dans les résultats : pas une cible de contrôle, et dans l’échantillon, sauf si sampling.csv en compte aussi d’autres
column-vehicles-discarded = pourquoi ce n’est pas le passage d’un véhicule à mesurer ; rien si c’en est un
column-vehicles-notes = remarques
column-vehicles-state = où en est le travail sur ce véhicule, d’après ce que demande le relevé
column-recordings-id = enregistrement
column-recordings-name = nom du fichier
column-recordings-sha256 = SHA-256 du fichier
column-recordings-size-bytes = taille du fichier
column-recordings-width-px = largeur d’une image
column-recordings-height-px = hauteur d’une image
column-recordings-frame-count = nombre d’images décodées
column-recordings-duration-s = durée de la première image à la fin de la dernière
column-recordings-codec = codec du flux vidéo
column-recordings-container = conteneur du fichier
column-recordings-variable-rate = true si le temps entre les images varie
column-recordings-stream-number = lequel des flux vidéo du fichier a été lu, à partir de 1 ; rien s’il n’en a qu’un
column-recordings-filmed-hz = images par seconde à la prise de vue, si une personne a dû l’indiquer
column-recordings-lighting = luminosité de l’enregistrement
column-recordings-started-at = quand sa première image a été filmée, comme une personne l’a confirmé, à l’heure du lieu (ISO 8601 avec décalage)
column-recordings-time-zone = fuseau horaire de ces heures (IANA)
column-recordings-weather = météo, en toutes lettres
column-recordings-street-lighting = si l’éclairage public était allumé
column-recordings-camera-id = caméra qui l’a filmé
column-recordings-pose-id = pose de la caméra en vigueur
column-recordings-drift-state = si la caméra a bougé depuis cette pose
column-recordings-drift-floor-px = limite de détection du mouvement de la caméra
column-recordings-drift-moved-px = plus grand mouvement trouvé, si elle a bougé
column-recordings-drift-height-m = plus grande erreur qui en résulte pour une hauteur de 1,2 m sur la route la plus proche dans l’image, à 3 m ou plus ; différente à d’autres distances
column-recordings-drift-distance-m = distance de la caméra, perpendiculairement à la route, à laquelle vaut cette erreur
column-recordings-drift-checked-at = quand cela a été contrôlé
column-recordings-drift-decision = pourquoi la pose a été gardée bien que la caméra ait bougé
column-recordings-drift-decided-by-id = qui en a décidé
column-recordings-drift-decided-at = quand cela a été décidé
column-poses-id = pose de la caméra
column-poses-recording-id = enregistrement où la mire était posée sur la chaussée
column-poses-calibration-id = étalonnage avec lequel elle a été calculée
column-poses-first-frame = première image du segment où la mire est visible
column-poses-last-frame = dernière image du segment où la mire est visible
column-poses-frames-used = nombre d’images entrées dans le calcul
column-poses-rms-px = moyenne quadratique des écarts des coins
column-poses-board-distance-m = distance du centre de la caméra à la mire
column-poses-board-columns = coins intérieurs par rangée de la mire
column-poses-board-rows = rangées de coins intérieurs
column-poses-square-m = côté d’une case
column-poses-reference = rangée de coins intérieurs dont la hauteur a été mesurée
column-poses-reference-height-m = hauteur de cette rangée au-dessus de la chaussée
column-poses-u-lean-rad = incertitude-type de l’inclinaison de la mire (k = 1)
column-poses-u-square-m = incertitude-type du côté d’une case (k = 1)
column-poses-u-bow-m = incertitude-type de la flèche de la mire en son milieu (k = 1)
column-poses-turned-from = pose dont celle-ci vient, avant d’être tournée selon le trafic
column-poses-turned-by-rad = angle dont elle a été tournée autour de la normale à la chaussée
column-poses-adjusted-from = pose dont celle-ci vient, avant d’être ajustée d’après son trafic (account : son document)
column-poses-document = la pose comme fichier de cette archive (sightline-pose-1)
column-poses-created-by-id = qui l’a faite
column-poses-created-at = quand elle a été faite
column-insets-target = ce qui est mesuré ; d’un œil de conducteur, pour le conducteur du côté proche ou du côté éloigné
column-insets-note = d’où vient la valeur
column-selection-by = ce d’après quoi on choisit
column-selection-word = la luminosité, le groupe de classes, la classe, le jour, ou l’heure du jour à l’heure du lieu
column-people-id = personne
column-people-name = nom
column-crops-k = laquelle des images de la mesure, à partir de 1
column-crops-file = la vue dans cette archive
column-crops-overlay = la même avec ses points, en SVG
column-crops-sha256 = SHA-256 de la vue
column-crops-x-px = colonne de l’image où commence la vue
column-crops-y-px = rangée de l’image où commence la vue
column-crops-width-px = largeur de la vue
column-crops-height-px = hauteur de la vue
column-crops-contact-x-px = contact du pneu avec la chaussée, dans la vue, x vers la droite ; (0, 0) est le centre du pixel en haut à gauche de la vue
column-crops-contact-y-px = contact du pneu avec la chaussée, dans la vue, y vers le bas ; (0, 0) est le centre du pixel en haut à gauche de la vue
column-crops-target-x-px = la cible, dans la vue, x vers la droite ; (0, 0) est le centre du pixel en haut à gauche de la vue
column-crops-target-y-px = la cible, dans la vue, y vers le bas ; (0, 0) est le centre du pixel en haut à gauche de la vue
column-crops-reason = pourquoi il n’y a pas de vue
column-exclusions-measurement-id = mesure exclue
column-exclusions-state = état pour lequel elle est exclue
column-exclusions-reason = le motif en toutes lettres
column-response-lighting = all : toutes, daytime : jour, low_light : faible luminosité, ou unknown : inconnue
column-response-class-set = all : tout, un groupe de classes (classes.csv), ou none : aucun
column-response-target = ce qui est demandé ; vide : le véhicule dans son ensemble
column-response-passes = passages trouvés
column-response-discarded = dont écartés (vehicles.csv dit pourquoi)
column-response-out-of-sample = dont hors échantillon
column-response-in-sample = dont dans l’échantillon
column-response-measured = de l’échantillon, mesurés
column-response-not-visible = de l’échantillon, non visibles
column-response-open = de l’échantillon, encore à faire
column-response-outside = mesurés bien que hors échantillon
column-response-rate = taux de réponse : measured sur in_sample
column-response-low = borne inférieure de son intervalle exact à 95 %
column-response-high = borne supérieure de son intervalle exact à 95 %
column-error-table-heights = inset : hauteurs corrigées du retrait de chaque mesure ; as_in_the_paper : avec un retrait de 0, les deux hauteurs d’une erreur au centimètre
column-error-table-rounding = cm : les deux hauteurs arrondies au centimètre, comme dans l’article ; none : non arrondies
column-error-table-group = groupe
column-error-table-figure = nom de la valeur
column-error-table-n = nombre de mesures
column-error-table-value = valeur
column-error-table-low = borne inférieure de son intervalle à 95 %
column-error-table-high = borne supérieure de son intervalle à 95 %
column-error-table-holds = composantes de son intervalle, séparées par des espaces
column-error-table-reason = pourquoi une valeur ou son intervalle manque
column-agreement-figure = quelle valeur ; _m et ordonnées à l’origine : en mètres
column-corrections-correction = laquelle des corrections des hauteurs (corrections.csv dit ce qui a été fait)
column-corrections-mean-m = moyenne des hauteurs corrigées
column-corrections-sd-m = écart-type des hauteurs corrigées (n - 1)
column-corrections-words = description de la correction
column-corrections-warning = avertissement
column-percentiles-grouping = ce qui divise les mesures ; all : rien
column-percentiles-percent = quel centile
column-percentiles-height-m = le centile
column-total-uncertainty-percent = d’un centile : lequel
column-total-uncertainty-limit-m = d’une part : sous quelle hauteur
column-total-uncertainty-value = la valeur : une hauteur ou un écart-type en mètres, une part de 0 à 1
column-total-uncertainty-raw-m = d’un centile : celui des hauteurs mesurées, sans correction
column-total-uncertainty-holds = composantes de l’intervalle, séparées par des espaces
column-same-rule-what = ce que concerne la hauteur de la norme
column-same-rule-standard = nom de la norme
column-same-rule-standard-m = hauteur de la norme
column-same-rule-percent = centile de sa règle
column-same-rule-class = de quels véhicules, d’après la norme
column-same-rule-by-class = false : aucune classe n’est connue, tous les véhicules comptent
column-same-rule-height-m = le même centile aujourd’hui, des hauteurs vraies
column-same-rule-low-m = borne inférieure de son intervalle total à 95 %
column-same-rule-high-m = borne supérieure de son intervalle total à 95 %
column-same-rule-difference-m = centile d’aujourd’hui moins la hauteur de la norme
column-same-rule-lower = probabilité que le centile d’aujourd’hui soit inférieur à la hauteur de la norme
column-same-rule-verdict = conclusion
column-same-rule-risk = probabilité que la conclusion soit fausse
column-shares-source = d’où vient la valeur de la norme
column-shares-below = nombre de hauteurs inférieures
column-shares-share = part des hauteurs inférieures : below divisé par n
column-lateral-positions-lane = sens de circulation sur l’image ; vide : tous
column-lateral-positions-class = carrosserie des véhicules ; vide : toutes

## La page d’un dossier de preuve : ouverte sans serveur, par quelqu’un qui n’a rien d’autre

opened-evidence-unreadable = Cette page ne peut pas lire ses données : le fichier a été tronqué ou modifié.
opened-evidence-title = Véhicule { $number }, { $scan }
opened-evidence-made = Dossier de preuve fait le { $at } UTC par { $by } avec Sightline { $version }.
opened-evidence-nobody = personne de connecté
opened-evidence-checking = Contrôle du fichier…
opened-evidence-is-fine = Les contrôles de cette page n’ont trouvé aucune contradiction.
opened-evidence-is-wrong = Ce fichier a été modifié après sa création.
opened-evidence-failed = Le fichier n’a pas pu être contrôlé en entier : { $words }.
opened-evidence-text-fine = Les données sont exactement dans la forme qui est signée (RFC 8785).
opened-evidence-text-wrong = Les données ne sont pas dans la forme qui est signée.
opened-evidence-pictures-fine = Les deux images correspondent aux SHA-256 des données.
opened-evidence-pictures-wrong = Images qui ne correspondent pas aux données : { $named }.
opened-evidence-events-fine = { $count ->
    [1] L’événement d’audit correspond à son empreinte.
   *[other] Les { NUMBER($count) } événements d’audit correspondent à leurs empreintes.
  }
opened-evidence-events-wrong = Événements d’audit qui ne correspondent pas à leurs empreintes : { $named }.
opened-evidence-event-fine = Le mouvement concorde avec son événement d’audit.
opened-evidence-event-wrong = Le mouvement diffère de son événement d’audit : { $named }.
opened-evidence-signature-holds = La signature est valable pour la clé { $key }…
opened-evidence-signature-wrong = La signature n’est pas valable pour la clé { $key }…
opened-evidence-signature-unknown = La signature n’a pas été contrôlée, car ce navigateur ne prend pas en charge Ed25519 ; les empreintes l’ont été. Utilisez sightline verify, ou un navigateur plus récent.
opened-evidence-proves = Une signature prouve seulement que le détenteur de cette clé a signé ces données, non qui détient la clé, ni que les données sont vraies, ni quand elles ont été établies. Comparez la clé à celle qu’affiche l’installation.
opened-evidence-what-here = Ici : les empreintes des deux images et des événements d’audit, le mouvement par rapport à son événement, et la signature avec la chaîne des clés.
opened-evidence-what-verify = Seulement par sightline verify : longueur, bilan d’incertitude, intervalle, heure et décision recalculés à partir des lignes des bornes et du dispositif, la décision de vérification par rapport à son événement, et le programme de cette page. Le mouvement lui-même vient des deux bandes entières, que l’installation garde.
opened-evidence-what-page = Un fichier peut être falsifié en entier, et dirait alors ce que veut le faussaire. Si l’enjeu le demande, lancez sightline verify avec la clé qu’affiche l’installation.
opened-evidence-data = Toutes les données de ce fichier
opened-evidence-decision = Décision
opened-evidence-decision-note = Règle : une décision n’est prise que si la valeur est au-delà de la limite, d’un côté ou de l’autre, d’au moins la bande de garde (JCGM 106:2012, 8.3), l’incertitude indiquée étant supposée de loi normale.
opened-evidence-rule-source = La limite : { $source }
opened-evidence-motion = Mouvement mesuré
opened-evidence-with-u = { $value } { $unit } (u = { $u } { $unit })
opened-evidence-speed = Vitesse quand l’avant atteint la caméra 1
opened-evidence-acceleration = Accélération
opened-evidence-length = Longueur
opened-evidence-direction = Sens
opened-evidence-direction-of = { $direction ->
    [camera_2_first] caméra 2 d’abord
   *[camera_1_first] caméra 1 d’abord
}
opened-evidence-lane-unknown = inconnue
opened-evidence-axles = Essieux
opened-evidence-axles-of = { NUMBER($count) }, { $by ->
    [person] comptés par une personne
   *[machine] trouvés par Sightline
}
opened-evidence-lines-1 = Avant et arrière à la caméra 1, ligne
opened-evidence-lines-2 = Avant et arrière à la caméra 2, ligne
opened-evidence-time-gap = Intervalle temporel avec le véhicule précédent
opened-evidence-distance-gap = Distance au véhicule précédent
opened-evidence-gap-none = aucun véhicule n’a été mesuré avant celui-ci
opened-evidence-method = Mesuré
opened-evidence-found = Bornes trouvées par Sightline, { $method ->
    [paper] appariement de blocs
   *[direct] recalage direct
  } ; révision { $revision } du { $at } UTC, Sightline { $version }
opened-evidence-placed = Bornes ou roues placées par une personne, { $method ->
    [paper] appariement de blocs
   *[direct] recalage direct
  } ; révision { $revision } du { $at } UTC, Sightline { $version }
opened-evidence-review = Vérification
opened-evidence-verdict = { $verdict ->
    [accepted] Validé par { $by } le { $at } UTC.
    [rejected] Rejeté par { $by } le { $at } UTC.
    [reopened] Rouvert par { $by } le { $at } UTC.
   *[to_review] Pas encore vérifié.
  }
opened-evidence-budget = Bilan d’incertitude
opened-evidence-budget-note = Incertitudes-types ; la dernière ligne est la racine de la somme de leurs carrés.
opened-evidence-source = Source
opened-evidence-u-speed = u de la vitesse, m/s
opened-evidence-u-acceleration = u de l’accélération, m/s²
opened-evidence-u-length = u de la longueur, m
opened-evidence-combined = composée
opened-evidence-time = Heure
opened-evidence-passed = Avant à la caméra 1
opened-evidence-passed-u = { $at } (u = { $u_s } s)
opened-evidence-start = Début confirmé de l’enregistrement
opened-evidence-start-u = { $at }, fuseau { $zone } (u = { $u_s } s)
opened-evidence-since = Depuis la première ligne
opened-evidence-clock-none = Le début de cet enregistrement n’est pas confirmé : il n’y a pas d’heure.
opened-evidence-rig = Dispositif et enregistrement
opened-evidence-baseline = Base
opened-evidence-baseline-there = Base au droit du véhicule
opened-evidence-rate = Cadence de lignes
opened-evidence-divergence = Divergence des plans de balayage
opened-evidence-distance = Distance aux véhicules
opened-evidence-lane = Voie
opened-evidence-shadow = Zone d’ombre, part basse des rangées
opened-evidence-misalignment = Désalignement en rangées, tel que réglé
opened-evidence-strips = Enregistrement
opened-evidence-strips-size = { $name } : { NUMBER($lines) } lignes de { $rows } rangées, { $bits } bits
opened-evidence-strip = SHA-256 de la bande stockée de la caméra { $camera }
opened-evidence-audit = Journal d’audit
opened-evidence-audit-end = La chaîne { $chain } avait { NUMBER($count) } événements quand ce fichier a été fait ; sa dernière empreinte était
opened-evidence-event = { $entity ->
    [scan_measurement] Mouvement { $number }
    [scan_review] Décision { $number }
   *[scan] Enregistrement { $number }
  } : { $action ->
    [create] création
    [read] lecture
    [recorded] enregistrement
    [reading_failed] échec de la lecture
    [restart_reading] nouvelle lecture
    [review] vérification
    [swap_cameras] échange des caméras
   *[update] modification
  }
opened-evidence-pair = { $first } ; { $second }
opened-evidence-event-number = N°
opened-evidence-event-at = Le (UTC)
opened-evidence-event-what = Événement
opened-evidence-event-hash = Empreinte
opened-evidence-keys = Les clés de l’installation jusqu’à celle qui a signé, chacune signée par la précédente :
opened-evidence-pictures = Les deux images, et vos propres bornes
opened-evidence-by-hand = Le temps va vers la droite, une colonne par ligne. Choisissez avant ou arrière, puis cliquez à sa place dans chaque image ; les champs ci-dessous acceptent aussi une ligne.
opened-evidence-set = { $edge ->
    [rear] Placer l’arrière (bleu)
   *[front] Placer l’avant (jaune)
  }
opened-evidence-zoom = Zoom
opened-evidence-show-lines = Afficher les bornes du fichier (tirets)
opened-evidence-camera = Caméra { $camera }
opened-evidence-quantity = Grandeur
opened-evidence-hand = Selon vos bornes
opened-evidence-file = Dans le fichier
opened-evidence-line = { $edge ->
    [rear] Arrière
   *[front] Avant
  } à la caméra { $camera }, ligne
opened-evidence-plain-front = Vitesse de l’avant
opened-evidence-plain-rear = Vitesse de l’arrière
opened-evidence-plain = Votre colonne applique la formule simple à partir de deux lignes : vitesse = base / temps entre les deux caméras ; longueur = moyenne des deux vitesses × temps à la caméra 1. Elle diffère du résultat du serveur, qui recale toutes les lignes intermédiaires et tient compte de l’accélération : la vitesse du fichier vaut quand l’avant atteint la caméra 1.
opened-evidence-no-speed = ces lignes ne donnent pas de vitesse
opened-evidence-not-set = placez les quatre bornes
opened-evidence-no-shift = pas de vitesse
opened-evidence-speed-of = { $kmh } km/h ({ $mps } m/s)
opened-evidence-overlay = Caméra 2 superposée à la caméra 1
opened-evidence-shift = Reculer la caméra 2 de (lignes)
opened-evidence-opacity = Opacité de la caméra 2
opened-evidence-difference = Afficher la différence
opened-evidence-shift-hand = { $edge ->
    [rear] Aligner vos arrières
   *[front] Aligner vos avants
  }
opened-evidence-shift-file = { $edge ->
    [rear] Aligner les arrières du fichier
   *[front] Aligner les avants du fichier
  }
opened-evidence-shift-words = { $lines } lignes font { $ms } ms ; base / temps donne { $speed }.

## Preuve d’un véhicule balayé : sa création, sa décision et son contrôle
evidence-no-rule = Aucune limite n’a été indiquée : aucune décision n’a été prise.
evidence-decided = { $answer ->
    [conforming] Conforme
    [not_conforming] Non conforme
   *[undecided] Indéterminé
  } : { $quantity ->
    [speed] la vitesse
    [time_gap] l’intervalle temporel
   *[distance_gap] la distance intervéhiculaire
  } est de { $value } { $unit } avec une incertitude-type de { $u } { $unit } ; { $side ->
    [upper] au plus
   *[lower] au moins
  } { $limit } { $unit } sont demandés. { $answer ->
    [conforming] La limite est respectée de plus que la bande de garde de { $guard } { $unit } ({ $factor } u) ; la probabilité que cette décision soit erronée est { $least ->
        [under] inférieure à
       *[about] d’environ
    } { $chance } %, et { $risk } % étaient admis.
    [not_conforming] La limite est enfreinte de plus que la bande de garde de { $guard } { $unit } ({ $factor } u) ; la probabilité que cette décision soit erronée est { $least ->
        [under] inférieure à
       *[about] d’environ
    } { $chance } %, et { $risk } % étaient admis.
   *[undecided] L’écart à la limite ne dépasse pas la bande de garde de { $guard } { $unit } ({ $factor } u) ; la décision la plus probable serait erronée avec une probabilité { $least ->
        [under] inférieure à
       *[about] d’environ
    } { $chance } %, et { $risk } % étaient admis.
  }
evidence-none-refused = Pas de décision : le véhicule n’a pas de mouvement mesuré. { $reason }
evidence-none-rig = Pas de décision : des valeurs du dispositif ont été modifiées après la mesure de ce véhicule, ou du précédent.
evidence-none-review = Pas de décision : { $verdict ->
    [rejected] un vérificateur a rejeté la mesure.
    [reopened] un vérificateur a rouvert la mesure, et personne ne l’a validée depuis.
   *[other] aucun vérificateur n’a validé la mesure.
  }
evidence-none-first = Pas de décision : aucun véhicule n’a été mesuré avant celui-ci, il n’y a donc pas d’intervalle.
evidence-none-before = Pas de décision : le véhicule { $number }, qui précède celui-ci, n’a pas de mouvement mesuré avec le dispositif actuel.
evidence-none-before-review = Pas de décision : { $verdict ->
    [rejected] un vérificateur a rejeté
    [reopened] personne n’a validé depuis sa réouverture
   *[other] aucun vérificateur n’a validé
  } la mesure du véhicule { $number }, qui précède celui-ci.
evidence-none-value = Pas de décision : il n’y a pas de valeur avec une incertitude. { $reason }
evidence-not-measured = Le véhicule { $number } n’est pas mesuré ; mesurez-le d’abord.
evidence-no-picture = La bande de la caméra { $camera } finit avant le véhicule ; placez son avant et son arrière dans la bande.
evidence-too-long = L’avant et l’arrière sont à { NUMBER($lines) } lignes l’un de l’autre, plus que n’en prend un véhicule ({ NUMBER($most) }) ; corrigez ses bornes.
evidence-pages-not-built = La page des dossiers de preuve n’est pas construite ici ; lancez make setup et réessayez.
evidence-one-limit = Indiquez une limite : --most-kmh, --least-time-gap-s ou --least-distance-gap-m, supérieure à 0 et inférieure à 10 000.
evidence-no-scan = Le relevé n’a pas d’enregistrement de balayage linéaire { $scan } ; il a : { $names }.
evidence-scans-several = Plusieurs enregistrements de balayage linéaire du relevé se nomment { $scan } ; indiquez le numéro de l’un d’eux : { $numbers }.
evidence-no-vehicle = Il n’y a pas de véhicule { $number } dans { $scan } ; vérifiez le numéro sur la page du balayage.
evidence-not-one = Ce n’est pas un dossier de preuve tel que ce programme les écrit, ou il a été tronqué ; reprenez le fichier.
evidence-form = La partie « { $part ->
    [page] page et forme
    [signature] signature et clés
    [pictures] images
    [events] événements d’audit
    [derived] valeurs déduites
    [numbers] valeurs mesurées
    [decision] décision
   *[said] phrases en d’autres langues
  } » est illisible ({ $words }) ; elle a été modifiée.
evidence-another-page = Le programme de la page n’est pas celui que nomme le document ; il a été modifié.
evidence-not-canonical = Le document n’est pas un JSON canonique ; il a été modifié.
evidence-signature = La signature n’est pas valable pour le document.
evidence-keys = Le document n’indique pas comment sa clé découle des précédentes.
evidence-other-key = Le fichier a été signé avec la clé { $key }, qui n’est pas liée à la clé indiquée ; il vient d’une autre installation ou est falsifié.
evidence-pictures = Les deux images, de la caméra 1 et de la caméra 2, ne sont pas toutes deux présentes.
evidence-picture = L’image { $name } n’est pas celle que nomme le document.
evidence-picture-size = L’image { $name } a une autre taille que ne le dit le document.
evidence-event = L’événement d’audit { $number } n’est pas celui qui a été haché, ou il est d’une autre chaîne.
evidence-no-event = Il n’y a pas d’événement d’audit { $part ->
    [before] du véhicule précédent
   *[measurement] de la mesure
  }.
evidence-not-as-event = { $part ->
    [before] Le véhicule précédent
   *[measurement] La mesure
  } diffère de ses événements d’audit : { $named }.
evidence-made-again = Recalculé à partir du document, ceci diffère : { $named }.
evidence-numbers = Pour { $part ->
    [before] le véhicule précédent
   *[measurement] la mesure
  }, ceci ne découle pas des lignes, du dispositif et du bilan d’incertitude : { $named }.
evidence-page-other-version = La page a été faite par une autre version du programme : son empreinte est signée, mais n’a pas été comparée à une page de cette version.
evidence-words-other-version = Une autre version a formulé la décision, dont les mots n’ont donc pas été comparés ; dans les mots de celle-ci : { $words }
evidence-key-given = La signature prouve ce que le détenteur de cette clé a signé, non qui détenait la clé, ni que cela est vrai, ni quand cela a été fait.
evidence-key-not-given = Signé avec la clé { $key } : un faussaire peut signer avec sa propre clé. Comparez-la à celle qu’affiche l’installation, ou indiquez celle-ci avec --key.
statistics-risk-cannot-be = Un risque de { $risk } est hors plage ; indiquez-en un de { $least } à { $most }.

## Une mire à imprimer

print-board-title = Damier : { $columns } × { $rows } coins intérieurs, cases de { $square_mm } mm
print-board-title-charuco = Mire ChArUco : { $columns } × { $rows } coins intérieurs, cases de { $square_mm } mm, marqueurs { $dictionary } de { $marker_mm } mm
print-board-check = Imprimez sur { $paper } à taille réelle (100 %), sans ajustement à la page. Mesurez ensuite la barre ci-dessus : elle fait { $bar_mm } mm de long. Si l’impression diffère, mesurez une rangée entière de cases et indiquez la taille réelle d’une case.
geometry-board-over-paper = La mire demande une feuille de { $width_mm } x { $height_mm } mm marge blanche comprise, plus grande que A0 ; choisissez des cases d’au plus { $square_mm } mm, ou nommez un rouleau de papier, par exemple 1200x900.
geometry-board-off-paper = La mire demande une feuille de { $width_mm } x { $height_mm } mm marge blanche comprise et ne tient pas sur { $paper } ; choisissez un papier plus grand, ou des cases d’au plus { $square_mm } mm.
geometry-paper-not-known = Le papier { $paper } ne peut pas être utilisé ; indiquez l’un de { $papers }, ou sa largeur et sa hauteur en mm, de { $least_mm } à { $most_mm } chacune, par exemple 841x1500.
reference-value-cannot-be = Une référence ({ $quantity }) de { $value } { $unit } est hors plage ; indiquez une valeur supérieure à { $least } et d’au plus { $most } { $unit }.
reference-u-cannot-be = Une incertitude de { $u } { $unit } pour { $quantity } de { $value } { $unit } est hors plage ; indiquez une incertitude-type supérieure à 0 et non supérieure à la valeur elle-même.
reference-device-too-long = Le nom de l’instrument dépasse { $most } caractères ; raccourcissez-le.
reference-withdrawn-already = Cette valeur de référence a déjà été supprimée ; il n’y a rien à faire.
reference-changed-meanwhile = { $name } a modifié cette valeur de référence entre-temps ; contrôlez-la d’abord.
reference-columns-missing = { $name } demande une colonne « number » (numéro du véhicule dans son enregistrement) ou « time » (heure de son passage) et l’une de speed_kmh, length_m, wheelbase_m ou run_of ; sa première ligne nomme les colonnes.
reference-column-unit = La colonne « { $column } » de { $name } n’indique pas son unité ; donnez-lui l’un de ces noms : { $names }, précédée de « u_ » pour l’incertitude.
reference-columns-of-one = Les colonnes « { $first } » et « { $second } » de { $name } indiquent la même chose ; retirez-en une.
reference-no-rows = { $name } a un en-tête et aucune ligne de valeurs de référence en dessous ; ajoutez-en une.
reference-no-line-used = Aucune ligne de { $name } n’est utilisable ; ligne { $line } : { $reason }
reference-line-no-number = Le numéro du véhicule est « { $number } » ; indiquez le nombre entier affiché sur la page du balayage.
reference-line-no-vehicle = Cet enregistrement n’a pas de véhicule { $number }.
reference-line-no-u = Aucune incertitude pour { $quantity } ; indiquez u_{ $quantity } à côté.
reference-line-no-value = Il y a une incertitude pour { $quantity }, mais pas de valeur.
reference-line-no-source = La source est « { $source } » ; utilisez l’une de : { $known }.
reference-line-empty = La ligne n’indique ni valeur ni véhicule.
reference-line-twice = La ligne { $line } indique déjà { $quantity } de ce véhicule par { $source }.
reference-line-no-time = « { $text } » n’est pas une heure avec secondes ; donnez-la sous la forme 14:05:32.4 ou 2025-05-14T14:05:32.4.
reference-line-no-date = L’enregistrement dure jusqu’à un autre jour, où { $time } revient ; donnez aussi la date.
reference-line-nobody = Aucun véhicule de cet enregistrement n’a d’heure, donc aucun n’est passé à moins de { $tolerance_s } s de { $time }.
reference-line-nobody-near = Aucun véhicule n’est passé à moins de { $tolerance_s } s de { $time } ; le plus proche est le véhicule { $number }, à { $apart_s } s.
reference-line-several = Les véhicules { $numbers } sont passés à moins de { $tolerance_s } s de { $time } ; donnez le numéro du bon.
reference-line-fits-others = D’après son heure c’est le véhicule { $number }, mais la ligne { $lines } donne aussi sa grandeur { $quantity } par { $source } ; donnez les numéros des véhicules.
reference-line-fits-cars = D’après son heure c’est le véhicule { $number }, mais la ligne { $lines } lui donne un autre nom de voiture ; donnez les numéros des véhicules.
reference-vehicle-without-time = Le véhicule { $number } n’a pas d’heure à comparer à celle-ci ; omettez l’heure.
reference-time-of-another = Le véhicule { $number } est passé à { $apart_s } s de cette heure, plus de { $tolerance_s } s.
reference-times-need-start = { $name } contient des heures, mais le début de ce balayage n’est pas confirmé, donc aucun véhicule n’a d’heure. Confirmez le début, ou donnez les numéros des véhicules.
reference-times-later = Les heures de { NUMBER($count) } lignes sont en retard de { $off_s } s (médiane) sur celles de leurs véhicules.
reference-times-earlier = Les heures de { NUMBER($count) } lignes sont en avance de { $off_s } s (médiane) sur celles de leurs véhicules.
reference-times-start = Le début de ce balayage n’est connu qu’à ± { $U95_s } s près, plus que la tolérance de { $tolerance_s } s : une ligne peut convenir à un voisin. Contrôlez les paires.
reference-unit-doubtful = { $quantity ->
    [speed] La vitesse
    [length] La longueur
   *[wheelbase] L’empattement
} de { NUMBER($count) } { $count ->
    [one] ligne
   *[other] lignes
} vaut environ { NUMBER($times, maximumFractionDigits: 2) } fois notre valeur : contrôlez l’unité indiquée par le nom de sa colonne.
reference-line-replaces = Remplace { $quantity } { $value } { $unit } (u = { $u } { $unit }).
reference-line-renames = Était un passage de { $car }.
reference-car-too-long = Le nom du véhicule dépasse 100 caractères ; raccourcissez-le.
scans-reference-differs = { $path } : { $name } de la ligne { $number } ne découle pas de la référence et de la valeur propre du véhicule.

## Said: motions, gaps and runs of line scans

scan-motion-lane-unknown = La voie n’est pas connue ({ $why }) : les incertitudes valent pour toutes les voies de son sens ; choisissez sa voie.
scan-lane-no-wheel = aucune roue trouvée n’indique la voie
scan-lane-not-this-way = aucune voie du dispositif n’a ce sens
scan-lane-other-rows = ses pneus touchent la chaussée à la rangée { $row }, { $lanes ->
    [0] hors des rangées de toute voie
   *[other] dans les rangées de plusieurs voies
 }
scan-gap-lane-unknown = Sa voie n’est pas connue ; le véhicule qui le précède ne l’est donc pas non plus.
scan-gap-before-unknown = Un véhicule dont la voie n’est pas connue l’a précédé, peut-être sur cette voie.
scan-gap-none-before = Aucun véhicule n’a été détecté devant celui-ci.
scan-gap-overlap = Les deux véhicules se recouvrent à la caméra 1 ; il n’y a pas d’intervalle.
scan-gap-other-rate = Les deux véhicules ont été mesurés à des cadences différentes ; mesurez-les tous deux à nouveau.
scan-gap-leader-unmeasured = Le véhicule précédent n’a pas de mouvement mesuré.
scan-gap-rear-unseen = L’arrière du véhicule précédent n’a pas été vu : il est resté arrêté trop longtemps en vue.
scan-gap-leader-stopped = À la décélération mesurée, le véhicule précédent se serait déjà arrêté.
scan-motion-too-coarse = Les lignes sont trop espacées pour ce véhicule : il avance d’environ { $line_mm } mm d’une ligne à la suivante, et des lignes voisines ont trop peu en commun. Portez la cadence à { $rate_hz } Hz ou plus pour des véhicules à cette vitesse ; une base plus longue n’y change rien.
scan-no-wheel = Aucune roue n’a été trouvée : le bas de l’image n’en montre pas, ou est trop sombre.
scan-no-scale = Sans mouvement mesuré, l’image n’a pas d’échelle en mètres.
scan-motion-implausible = La { $what ->
    [speed] vitesse
    [length] longueur
   *[acceleration] accélération
 } calculée de { NUMBER($value, minimumFractionDigits: 1, maximumFractionDigits: 1) } { $unit } n’est pas plausible pour un véhicule routier ({ $low } à { $high } { $unit }) : contrôlez les bornes, la base et la cadence.
scan-motion-no-uncertainty = Trop peu du véhicule a été apparié pour donner l’incertitude de son mouvement : contrôlez les bornes dans les deux images.
scan-motion-would-stop = D’après le mouvement calculé, le véhicule se serait arrêté en vue ; contrôlez les bornes.
scan-motion-u-large = L’U95 de la { $what ->
    [speed] vitesse
   *[length] longueur
 } est de { $percent } %, trop pour être utile : trop peu du véhicule est net, les bornes sont fausses, ou deux véhicules passent à la fois.
scan-motion-u-acceleration-large = L’U95 de l’accélération est de { $U95_mps2 } m/s², plus que ne freine aucun véhicule : trop peu du véhicule est net, ou les bornes sont fausses.
scan-motion-no-order = Les bornes ne sont pas dans l’ordre : l’avant doit précéder l’arrière devant les deux caméras.
scan-motion-no-texture = Trop peu du véhicule est assez net pour être recalé d’une bande à l’autre. Contrôlez les bornes ; si elles sont justes, enregistrez avec plus de contraste : mise au point, lumière ou exposition.
scan-motion-no-match = Les deux images du véhicule ne suivent pas un même mouvement : deux véhicules côte à côte, un véhicule arrêté ou des lignes perdues. Contrôlez les bornes aux deux caméras ; si elles sont justes, laissez-le non mesuré.
scan-motion-few-lines = Environ { $lines } lignes seulement ont été enregistrées entre les deux caméras, trop peu pour la vitesse ou le sens : augmentez la cadence, ou écartez les caméras.
scan-motion-few-blocks = Trop peu de blocs de { $lines } lignes peuvent être appariés : le véhicule présente trop peu de détails, ou trop peu de lignes ; augmentez la cadence de lignes, ou utilisez l’autre méthode.
scan-motion-not-converged = Le recalage des deux images s’est arrêté avant de se stabiliser : la vitesse, l’accélération et la longueur peuvent être fausses de plus que leurs incertitudes ne le disent. Contrôlez les bornes dans les deux images ; si l’avertissement demeure, rejetez le véhicule.
scan-motion-cameras-disagree = Les caméras diffèrent de { $apart_cm } cm sur l’avant ou l’arrière : contrôlez les bornes, et si deux véhicules passent côte à côte.
scan-motion-saturated = Une partie de l’image est saturée ; réduisez l’exposition.
scan-motion-stopped = Le véhicule s’est arrêté ou presque devant les caméras ; marquez-en un autre, ou mesurez-le à la main.
scan-motion-stood = Le véhicule est resté arrêté en vue si longtemps que son arrière n’a pas été vu ; mesurez-le à la main.
scan-motion-too-long-in-view = Quelque chose est resté en vue plus longtemps qu’un passage ; arrêt, ou changement de lumière. Regardez les deux bandes : retirez-le si ce n’est pas un véhicule, ou placez ses bornes à la main.
scan-motion-cut = Le véhicule est coupé par le début ou la fin de l’enregistrement. Si ses deux extrémités sont sur les bandes, placez ses bornes à la main ; commencez et terminez les enregistrements sur une chaussée vide.
scan-motion-no-road = La chaussée vide avant le véhicule est trop instable : neige, pluie, ou trafic dès la première ligne ; commencez l’enregistrement quand la chaussée est vide.
scan-motion-too-long = Sa longueur estimée est de { $length_m } m, et la limite de { $most_m } m : un train, des véhicules sans intervalle, ou une base ou une cadence fausse.
scan-motion-two-at-once = Les caméras le montrent pendant des durées différentes : deux véhicules côte à côte, ou un arrêt.
scan-motion-lines-lost = L’enregistreur a perdu { $lost } pendant le passage du véhicule. Ce passage n’est pas mesurable ; cherchez pourquoi l’enregistreur perd des lignes avant d’enregistrer à nouveau.
scan-lines-of-camera = { NUMBER($count) } lignes de la caméra { $camera }
words-both = { $first } et { $second }
scan-motion-no-wheelbase = Pas d’empattement : { $reason }
scan-wheelbase-no-motion = Le véhicule n’a pas de mouvement mesuré.
scan-wheelbase-one-wheel = Cliquez sur les moyeux de deux roues différentes.
scan-wheelbase-at-rest = D’après son mouvement ajusté, le véhicule était arrêté à l’un des pointés.
scan-run-none-found = Aucun véhicule n’a été trouvé ; contrôlez les bandes, et que le temps court selon l’axe choisi.
scan-run-swapped = { NUMBER($reversed) } véhicules sur { NUMBER($found) } ont atteint d’abord la deuxième bande ; si le trafic ne va pas dans ce sens ici, les bandes sont inversées.
scan-run-alone = { $alone } objets ne sont passés que devant une caméra : vérifiez que les deux montrent la même voie, et contrôlez base et cadence de lignes.
scan-run-stood-in-front = Un véhicule s’est arrêté devant un autre à l’arrêt ; il peut manquer, ainsi que des véhicules passés pendant ce temps.
scan-run-rests-again = Quelque chose s’est arrêté devant un véhicule à l’arrêt ({ NUMBER($count) } fois). Chaque arrêt compte comme un autre véhicule, mais c’est peut-être le même, un peu plus loin : regardez les bandes.
scan-run-light-changed = La luminosité a varié brusquement ({ NUMBER($count) } fois) ; les véhicules passés à ce moment peuvent manquer.
scan-run-camera-moved = Une caméra a bougé ({ NUMBER($count) } fois) : depuis, la chaussée est quelques rangées plus haut ou plus bas ; fixez la caméra solidement.
scan-run-road-unsteady = La chaussée vide de la caméra { $camera } varie de { $percent } % d’une ligne à l’autre : neige, pluie, ou véhicule au début ; enregistrez d’abord la chaussée vide.
scan-run-short-objects = La caméra { $camera } montre { $per_s } objets courts par seconde : pluie, neige ou insectes ; contrôlez les bornes.
scan-run-flicker = La lumière à la caméra { $camera } scintille de { $percent } %, comme un éclairage sur secteur ; changez d’éclairage, ou attendez-vous à des incertitudes plus grandes.
scan-run-saturated = { $percent } % de l’image de la caméra { $camera } est saturée ; réduisez l’exposition.
rig-misalignments-scatter = Le désalignement diffère d’un véhicule à l’autre de { NUMBER($sd_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px (écart-type) ; vérifiez si une caméra a bougé.
rig-few-known = { NUMBER($count) } véhicules connus ne suffisent pas ; il en faut { $least }.
rig-misalignment-given = Le désalignement a été saisi : les estimations des véhicules en dépendent ; laissez-le vide et mesurez à nouveau pour l’estimer.
rig-baseline-off = D’après { NUMBER($count) } { $of ->
    [length] longueurs
   *[wheelbase] empattements
 }, les véhicules connus ressortent de { NUMBER($percent, minimumFractionDigits: 2, maximumFractionDigits: 2) } % plus { $than ->
    [longer] longs
   *[shorter] courts
 } qu’ils ne sont (u = { NUMBER($u_percent, minimumFractionDigits: 2, maximumFractionDigits: 2) } %) : une base plus { $than ->
    [longer] courte
   *[shorter] longue
 } leur conviendrait. Contrôlez la base.{ $of ->
    [length] { " " }Les ombres peuvent aussi allonger ; les empattements en sont exempts.
   *[wheelbase] { "" }
 }
rig-baseline-agrees = { NUMBER($count) } { $of ->
    [length] longueurs
   *[wheelbase] empattements
 } de véhicules connus s’écartent en moyenne de { NUMBER($off_percent, minimumFractionDigits: 2, maximumFractionDigits: 2) } % de leur valeur, dans l’U95 de cette moyenne ({ NUMBER($U95_percent, minimumFractionDigits: 2, maximumFractionDigits: 2) } %).
scan-flow-no-speed = Aucun véhicule n’a ici de vitesse validée.
scan-flow-rear-unseen = Le taux d’occupation n’est pas connu : l’arrière d’un véhicule arrêté ici n’a pas été vu.
scan-flow-no-u-occupancy = L’incertitude du taux d’occupation n’est pas connue : { NUMBER($count) } des véhicules n’ont pas de vitesse validée.
stream-lines-lost = { NUMBER($count) } lignes de la caméra { $camera } ont été perdues et remplacées par des copies ; les véhicules passés pendant ce temps ne sont pas mesurés.
stream-vehicles-wait = { $message } { NUMBER($waiting) } véhicules attendent d’être enregistrés dans le relevé.
stream-recording-deleted = { $recording } a été supprimé pendant le flux : plus aucun de ses véhicules n’est enregistré, et ses deux bandes sont supprimées à sa fin.
stream-recording-not-there = { $recording } est introuvable dans ce relevé : plus aucun de ses véhicules n’est enregistré.
stream-refused = { $message } Cette exécution n’enregistre plus rien dans le relevé ; les véhicules sont toujours affichés.
stream-strip-changed = { $name } n’arrive pas tel qu’il a été envoyé ; vérifiez si un autre programme y écrit.
stream-strips-kept = Les bandes de { $recording } restent dans { $first } et { $second } ; le prochain flux avec ce dossier essaiera de nouveau de les enregistrer.
stream-stopped = L’exécution précédente a été interrompue après { NUMBER($lines) } lignes (segment { $number }, dernier contact { $last_at } UTC). Ses véhicules sont conservés ; manquent les { NUMBER($gap_s, minimumFractionDigits: 1, maximumFractionDigits: 1) } s (environ { NUMBER($gap_lines) } lignes) écoulées depuis, et le véhicule en vue.
stream-resumed = L’exécution précédente a été interrompue ; elle reprend à la ligne { $begin } de { $name }, et rien ne manque.
stream-clock-set = L’horloge de l’ordinateur a été réglée de { NUMBER($jump_s, minimumFractionDigits: 1, maximumFractionDigits: 1) } s à la ligne { $lines } ; vitesses, longueurs et intervalles n’en dépendent pas, et les heures continuent depuis le début de ce segment.
stream-lines-not-stored = Les lignes suivantes n’ont pu être enregistrées ({ $strerror }) ; elles ont été mesurées tout de même.
stream-journal-not-written = Le journal n’a pu être écrit ({ $strerror }).
stream-lines-stored = { NUMBER($kept) } lignes sont enregistrées dans { $path }.
rig-few-vehicles = { NUMBER($count) } véhicules donnent un { $of ->
    [misalignment] désalignement
   *[gain] gain
 } ; il en faut { $least }.
scan-motion-not-finite = La { $what ->
    [speed] vitesse
    [length] longueur
   *[acceleration] accélération
 } calculée n’est pas un nombre : contrôlez les bornes, la base et la cadence.

## Said: boards, calibrations, camera poses and the traffic’s say on them

board-not-found = Aucune mire n’a été trouvée.
board-search-stopped = La recherche a été arrêtée.
board-none = Aucune mire de { $columns }x{ $rows } coins intérieurs n’a été trouvée ; montrez la mire entière avec sa marge blanche, nette et éclairée uniformément, et comptez les coins intérieurs.
board-none-in-time = Aucune mire de { $columns }x{ $rows } coins intérieurs n’a été trouvée dans le temps imparti à la recherche ; montrez la mire entière avec sa marge blanche, nette et éclairée uniformément, et comptez les coins intérieurs.
board-cut-off = La mire est coupée par le bord de l’image ; montrez-la en entier.
board-squares-tiny = Les cases font moins de 3 px ; approchez la mire ou prenez des cases plus grandes.
board-markers-tiny = Les cases font moins de 3 px ; approchez la mire.
board-no-checkerboard = Le motif trouvé n’est pas un damier.
board-picture-too-small = L’image est trop petite pour contenir une mire.
board-none-with-markers = Aucune mire ChArUco de { $columns }x{ $rows } coins intérieurs avec des marqueurs { $dictionary } n’a été trouvée, ou trop peu ; elle doit être nette et de ce dictionnaire.
board-goes-on = La mire continue { $side ->
    [left] à gauche
    [right] à droite
    [above] en haut
   *[below] en bas
 } au-delà de { $columns }x{ $rows } coins intérieurs ; recomptez-les.
board-corners-uneven = Les coins trouvés ne forment pas une grille régulière ; quelque chose couvre la mire ou elle n’est pas plane.
board-moved-far = La mire a trop bougé entre deux images.
board-no-frame = Aucune image n’a été donnée.
board-corners-few = Au plus { $parts } de ses { $whole } coins ont été trouvés ; montrez la mire entière.
board-order = Les coins sont numérotés depuis le haut à gauche tel que vu, le long des rangées vers la droite puis vers le bas.
board-order-part = { $seen } de ses { $all } coins sont visibles ; cela suffit à un étalonnage, mais une pose de la caméra les demande tous.
board-order-turned = La mire est tournée : { $columns } colonnes sur { $rows } rangées telles que vues, et non telles que saisies.
pose-frames-without-board = La mire n’a pas été trouvée dans { $missed } des images ; celles-ci ne servent pas.
pose-frames-moved = La mire ou la caméra a bougé dans certaines images ; seules servent les images au repos.
pose-corners-miss-model = Les coins ne suivent le modèle qu’à { NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px près ; la mire est peut-être courbée ou l’étalonnage mauvais.
pose-two-fit = Deux poses s’accordent presque aussi bien à la mire ; tournez la caméra d’une trentaine de degrés le long de la route, ou approchez la mire.
pose-squares-small = Les cases sont petites dans l’image ; approchez la mire.
pose-board-rolled = La mire paraît tournée de { $roll_deg } degrés ; contrôlez que colonnes et rangées ne sont pas inversées.
pose-image-twice = { $name } est la même image que { $file } ; elle compte une fois.
pose-frames-twice = { $count ->
    [one] { NUMBER($count) } image de { $name } a déjà été donnée ; elle compte une fois.
   *[other] { NUMBER($count) } images de { $name } ont déjà été données ; elles comptent une fois.
}
pose-one-frame = Une seule image est utilisée ; l’immobilité de la mire n’est pas contrôlée.
pose-road-turned = Pivotée de { NUMBER($heading_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) } degrés vers le sens de circulation.
pose-turned-by-vehicles = Pivotée de { NUMBER($turn_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) }° vers le sens de { NUMBER($vehicles) } véhicules.
pose-adjusted-by-passes = Ajustée par { NUMBER($passes) } passages d’empattement ou de hauteur connus.
pose-before = La pose précédente est le numéro { $pose }.
pose-simulated = Simulée.
pose-board-distance = La mire était à { NUMBER($distance_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m de la caméra.
pose-camera-height = La caméra est à { NUMBER($height_m, minimumFractionDigits: 2, maximumFractionDigits: 2) } m au-dessus de la route.
pose-expected-heights = U95 attendue d’une hauteur de 1,2 m, sans la part du retrait, pointée avec u = 1 px : { $figures }.
pose-expected-at = ± { SMALL($U95_height_m) } à { $distance_m } m
pose-no-road-at-distance = L’image ne montre pas la route à cette distance.
words-comma = { $first }, { $second }
calibration-image-other-size = La photo fait { $width_px }x{ $height_px } px, la plupart des autres { $usual_width_px }x{ $usual_height_px } px.
calibration-image-blurred = La photo est floue (bords larges de { NUMBER($edge_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px).
calibration-image-twice = La photo est la même que { $file } ; prenez chaque vue une seule fois.
calibration-no-covariance = Le fichier n’indique pas d’incertitude de l’objectif ; cette composante manque dans l’incertitude de chaque hauteur.
calibration-made = { $used } vues utilisées sur { $given }, résidu { NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px, focale { NUMBER($focal_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px.
calibration-made-u = { $used } vues utilisées sur { $given }, résidu { NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px, focale { NUMBER($focal_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px (incertitude-type { NUMBER($u_focal_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px).
calibration-imported = Importé de { $file_name } : modèle { $model }, focale { NUMBER($focal_px, minimumFractionDigits: 1, maximumFractionDigits: 1) } px.
calibration-board-bent = La mire n’est pas plane : elle fléchit d’environ { NUMBER($bow_percent, minimumFractionDigits: 1, maximumFractionDigits: 1) } % d’une case ; avec sa forme estimée, le résidu passe de { NUMBER($flat_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } à { NUMBER($bent_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px. Fixez la mire sur une plaque rigide et plane et reprenez les photos, ou étalonnez en tenant compte de la flèche.
calibration-board-bent-changes = La mire n’est pas plane : elle fléchit d’environ { NUMBER($bow_percent, minimumFractionDigits: 1, maximumFractionDigits: 1) } % d’une case ; avec sa forme estimée, le résidu passe de { NUMBER($flat_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } à { NUMBER($bent_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px et une hauteur à { $distance_m } m change de { SMALL($change_m) }. Fixez la mire sur une plaque rigide et plane et reprenez les photos, ou étalonnez en tenant compte de la flèche.
calibration-halves-few = Deux moitiés demandent au moins { $least } vues utilisables{ $board ->
    [bent] { " " }d’une mire courbée
   *[flat] { "" }
 } ; il y en a { $usable }. Prenez d’autres photos.
calibration-halves-failed = Les deux moitiés n’ont pas pu être étalonnées séparément : { $message }
calibration-halves-no-inverse = Une mire est là où le modèle d’objectif n’a pas d’inverse ; ajoutez des photos qui atteignent les coins.
calibration-halves-differ = Deux moitiés des photos, étalonnées séparément, diffèrent de { SMALL($difference_m) } pour une hauteur à { $distance_m } m : plus que le bruit des coins ne l’explique. L’objectif demande peut-être l’autre modèle, la mire est peut-être courbée, ou le zoom ou la mise au point a changé entre les photos.
calibration-halves-differ-beyond = Deux moitiés des photos, étalonnées séparément, diffèrent de { SMALL($difference_m) } pour une hauteur à { $distance_m } m ({ SMALL($expected_m) } attendus) : plus que le bruit des coins ne l’explique. L’objectif demande peut-être l’autre modèle, la mire est peut-être courbée, ou le zoom ou la mise au point a changé entre les photos.
calibration-held-out-worse = Les photos hors ajustement s’accordent bien moins que les photos ajustées ({ NUMBER($held_out_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px contre { NUMBER($fit_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px) ; ajoutez des photos où la mire est inclinée, partout dans l’image.
calibration-few-views = Seules { NUMBER($count) } vues ont servi : sous { $few }, un petit résidu prouve peu ; prenez-en 15 à 25.
calibration-views-alike = Seules { $different } des { NUMBER($count) } vues diffèrent, car la mire n’a guère bougé entre les autres ; déplacez-la et inclinez-la entre les photos, ou prenez des images plus éloignées.
calibration-little-covered = Les mires couvrent { $percent } % de l’image ; ajoutez des vues qui atteignent ses bords et ses coins, où la distorsion est la plus forte.
calibration-boards-parallel = Toutes les mires sont orientées de même : focale et distance ne se distinguent pas ; inclinez la mire de 30 à 45 degrés dans plusieurs directions.
calibration-residual-high = Le résidu de { NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px est élevé ; la mire n’est peut-être pas plane, sa taille est peut-être fausse, ou l’objectif demande un autre modèle.
calibration-other-model-better = Le modèle { $model } convient mieux ({ NUMBER($other_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px contre { NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px) ; étalonnez avec lui.
calibration-lens-undetermined = Les vues ne déterminent pas l’objectif ; son incertitude ne peut être indiquée.
calibration-focal-vague = La focale n’est connue qu’à { NUMBER($percent, minimumFractionDigits: 1, maximumFractionDigits: 1) } % ; prenez d’autres vues, inclinées et proches.
lens-axis-off-middle = L’axe optique est loin du milieu de l’image ; la photo a-t-elle été recadrée ?
lens-pixels-not-square = Les deux focales diffèrent de plus de 10 % ; les pixels sont-ils carrés ?
lens-no-inverse-in-corners = Le modèle d’objectif ne s’inverse pas dans les coins de l’image : rien n’y est mesuré ; ajoutez des photos qui atteignent les coins.
calibration-squares-small = Dans { $small } vues sur { $views }, les cases font moins de { $least_px } px et leurs coins sont inexacts ; approchez la mire ou prenez des cases plus grandes.
calibration-several-sizes = Photos de plusieurs tailles : { NUMBER($count) } ignorées qui ne font pas { $width_px }x{ $height_px } px (d’abord { $file }) ; un étalonnage ne vaut que pour une taille, prenez des photos à la taille des enregistrements.
calibration-board-seldom = La mire n’a servi que dans { $used } photos sur { $given } ; recomptez ses coins intérieurs et montrez-la entière, nette et éclairée uniformément.
calibration-image-outlier = { $file } s’accorde bien moins que les autres ({ NUMBER($rms_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px contre { NUMBER($usual_px, minimumFractionDigits: 2, maximumFractionDigits: 2) } px) ; contrôlez ses coins.
calibration-tilt-edge = Inclinez la mire d’environ 30 degrés, son bord { $edge } plus près de la caméra.
calibration-tilt-edges = Inclinez la mire d’environ 30 degrés, tour à tour son bord { $edges } plus près de la caméra.
board-edge = { $edge ->
    [left] gauche
    [right] droit
    [top] supérieur
   *[bottom] inférieur
 }
image-part = { $place ->
    [top-left] en haut à gauche
    [top-centre] en haut au centre
    [top-right] en haut à droite
    [middle-left] au milieu à gauche
    [middle-right] au milieu à droite
    [bottom-left] en bas à gauche
    [bottom-centre] en bas au centre
    [bottom-right] en bas à droite
   *[middle-centre] centre
 }
calibration-bring-nearer = Approchez la mire : elle ne remplit jamais plus de { $percent } % de l’image ; un tiers ou plus convient.
calibration-hold-in = Tenez la mire dans cette partie de l’image : { $parts }.
import-several-cameras = { $file_name } contient plusieurs caméras : { $cameras } ; { $key } a été lue (nommez-en une autre avec --which).
import-roi-whole = { $file_name } : la caméra est celle de l’image entière, comme demandé, et non de sa roi.
import-roi-part = { $file_name } décrit une partie de l’image (roi) : { $width }x{ $height } px à partir de ({ $left } ; { $top }) sur { $full_width }x{ $full_height } px ; la caméra est celle de cette partie (--size { $full_width }x{ $full_height } pour l’image entière).
import-no-distortion = { $file_name } indique un objectif sans aucune distorsion, ce qui est rare ; contrôlez que cette caméra a été étalonnée.
import-model-guessed = { $file_name } ne nomme pas son modèle de distorsion ; ses quatre coefficients ont été lus comme { $taken } (à choisir par --model).
adjustment-length-not-finite = La valeur ({ $length ->
    [wheelbase] empattement
    [roof] hauteur du toit
   *[roof_inset] retrait du toit
 }) ou son incertitude n’est pas un nombre fini, ou l’incertitude est négative.
adjustment-length-not-positive = La valeur ({ $length ->
    [wheelbase] empattement
    [roof] hauteur du toit
   *[roof_inset] retrait du toit
 }) n’est pas positive.
adjustment-length-off = Sa longueur connue ({ $length ->
    [wheelbase] empattement
    [roof] hauteur du toit
   *[roof_inset] retrait du toit
 }) de { NUMBER($known_m, minimumFractionDigits: 3, maximumFractionDigits: 3) } m est de { NUMBER($deviate, minimumFractionDigits: 1, maximumFractionDigits: 1) } incertitudes-types trop { $than ->
    [long] grande
   *[short] petite
 } pour les points observés ; vérifiez le modèle.
adjustment-crooked = Trop de ses points ne sont pas sur une même ligne droite.
adjustment-point-outside = Un point est hors de l’image.
adjustment-tyre-off-road = Un pneu est là où il n’y a pas de route : au-dessus de l’horizon, ou hors du rayon de validité du modèle d’objectif.
adjustment-part-excluded = Le trafic contredit ce terme : { $part ->
    [board_lean_rad] { adjust-moved-board_lean_rad }
    [board_roll_rad] { adjust-moved-board_roll_rad }
    [board_height_m] { adjust-moved-board_height_m }
    [square_m] { adjust-moved-square_m }
    [bow_along_rows_m] { adjust-moved-bow_along_rows_m }
    [bow_down_columns_m] { adjust-moved-bow_down_columns_m }
    [wheelbase_common_m] { adjust-moved-wheelbase_common_m }
   *[roof_common_m] { adjust-moved-roof_common_m }
 }, avec son u indiquée de { $u } { $unit } ; il a été exclu.
adjustment-common-far-off = Une valeur est loin de 0 pour son u indiquée de { $u } { $unit } : { $part ->
    [board_lean_rad] { adjust-moved-board_lean_rad }
    [board_roll_rad] { adjust-moved-board_roll_rad }
    [board_height_m] { adjust-moved-board_height_m }
    [square_m] { adjust-moved-square_m }
    [bow_along_rows_m] { adjust-moved-bow_along_rows_m }
    [bow_down_columns_m] { adjust-moved-bow_down_columns_m }
    [wheelbase_common_m] { adjust-moved-wheelbase_common_m }
    [roof_inset_common_m] { adjust-moved-roof_inset_common_m }
   *[roof_common_m] { adjust-moved-roof_common_m }
 }. Vérifiez que les longueurs connues se rapportent aux points suivis.
adjustment-points-scatter = Les points se dispersent { NUMBER($factor, minimumFractionDigits: 1, maximumFractionDigits: 1) } fois plus qu’indiqué ; leurs incertitudes ont été multipliées par ce facteur.
adjustment-lengths-scatter = Les valeurs connues ({ $length ->
    [wheelbase] empattement
    [roof] hauteur du toit
   *[roof_inset] retrait du toit
 }) se dispersent { NUMBER($factor, minimumFractionDigits: 1, maximumFractionDigits: 1) } fois plus qu’indiqué ; leurs incertitudes ont été multipliées par ce facteur.
adjustment-global-test-failed = Le test global échoue : khi-deux { $chi2 } pour { $freedom ->
    [one] { NUMBER($freedom) } degré
   *[other] { NUMBER($freedom) } degrés
 } de liberté ; les incertitudes indiquées ne sont pas compatibles entre elles.
adjustment-few-vehicles = Avec { NUMBER($count) } véhicules, un véhicule erroné ne se distingue pas d’une pose erronée.
adjustment-pose-unchanged = Aucun passage de longueur connue n’a pu servir ; la pose est inchangée.
adjustment-point-not-finite = Un point ou son incertitude n’est pas un nombre fini.
adjustment-point-no-u = L’incertitude d’un point est inférieure à 0,001 px.
adjustment-point-twice = Un point est donné deux fois sur une image.
adjustment-no-tyre = Aucun pneu de ce véhicule n’est mesuré ; rien ne le rattache à la chaussée.
adjustment-no-known-length = Aucune longueur connue de ce véhicule n’est mesurée.
adjustment-no-model = Sa marque et son modèle ne sont pas renseignés ; son empattement est inconnu.
adjustment-no-wheelbase = Le catalogue n’a pas d’empattement pour ce modèle et cette année.
adjustment-several-wheelbases = Le catalogue a plusieurs empattements pour ce modèle ; indiquez l’année.
adjustment-no-height = La hauteur du constructeur n’est pas renseignée.
adjustment-model-by-size = Son modèle a été choisi d’après ses dimensions : ce qui est connu du modèle n’est pas une référence.
adjustment-roof-not-near-edge = Le toit n’a pas été pointé à son bord proche.
adjustment-no-lengths-yet = Aucune longueur n’est encore connue : pointez les deux pneus de véhicules d’un modèle connu, ou mesurez leur toit.
adjustment-done-before = Cette pose est déjà ajustée sur le trafic.
adjustment-no-pass = Aucun passage de longueur connue n’a pu servir.
traffic-turned = L’axe X de la route est pivoté de { NUMBER($mean_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) }° (u = { NUMBER($u_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) }°, { NUMBER($count) } véhicules) par rapport au trafic.
traffic-agrees = L’axe X de la route s’accorde avec le trafic : rotation de { NUMBER($mean_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) }° (u = { NUMBER($u_deg, minimumFractionDigits: 2, maximumFractionDigits: 2) }°, { NUMBER($count) } véhicules), non significative.
traffic-turn-changes = Cela change { NUMBER($count) } hauteurs enregistrées de { SMALL($largest_m) } au plus.
traffic-turn-would-change = Cette rotation changerait les hauteurs enregistrées de { SMALL($largest_m) } au plus.
traffic-few-vehicles = Il faut les deux contacts de pneu d’au moins { $least } véhicules ; utilisables : { $usable }.
adjustment-row-frame = Ligne { $row } : la cellule frame n’est pas un nombre entier.
adjustment-row-point = Ligne { $row } : la cellule point n’est pas l’un de { $points }.
adjustment-row-another = Ligne { $row } : une autre valeur de { $column } est donnée pour le même passage.
adjustment-u-lacking = { $given } est donné sans { $lacking }.

## Said: insets, repeats and models that fit

inset-few-known = Il faut au moins { $least } véhicules de hauteur connue ; utilisables : { $usable }.
inset-known-at-camera-height = Non concluant : les véhicules sont à peu près à la hauteur de la caméra, où le retrait a peu d’effet.
inset-none-fits = Aucun retrait ne s’accorde aux hauteurs du constructeur ; contrôlez-les, ainsi que la hauteur de la caméra et les pointés.
inset-known-vague = Non concluant : trop peu de véhicules, ou hauteurs trop proches de celle de la caméra ou trop incertaines.
inset-few-trend = Il faut au moins { $least } véhicules ; utilisables : { $usable }.
inset-no-trend = Le retrait ne peut pas être estimé : trop peu de véhicules, ou tous à peu près à la même distance.
inset-trend-at-camera-height = Non concluant : cette cible est à peu près à la hauteur de la caméra, où le retrait a peu d’effet.
inset-trend-one-distance = Non concluant : tous sont passés à peu près à la même distance, { NUMBER($nearest_m, minimumFractionDigits: 1, maximumFractionDigits: 1) } à { NUMBER($farthest_m, minimumFractionDigits: 1, maximumFractionDigits: 1) } m.
inset-trend-few = Pas assez de données : il faut quelques centaines de véhicules pour u = 0,15 m.
inset-few-solved = Il faut au moins { $least } véhicules mesurés sur deux images ; il y en a { NUMBER($count) }.
inset-solved-close-frames = Non concluant : les images étaient trop rapprochées.
inset-no-gain = S’accorde avec le retrait en vigueur ; l’adopter ne réduirait l’incertitude d’aucune hauteur.
inset-no-known-roof = Aucun véhicule dont la hauteur du constructeur est connue n’a de toit mesuré.
inset-nothing-measured = Aucune mesure de cette cible.
repeat-first-no-height = Les premiers pointés ne donnent pas de hauteur : { $reason }
repeat-second-no-height = Les seconds pointés ne donnent pas de hauteur : { $reason }
repeat-other-frame = Pointées sur des images différentes : les pointés ne sont pas seuls à différer.
repeat-other-pose = La pose de la caméra a changé depuis : les pointés ne sont pas seuls à différer.
repeat-other-inset = Les retraits diffèrent : les pointés ne sont pas seuls à différer.
repeat-no-uncertainty = Une hauteur est sans incertitude.
repeats-few-own = Répétitions propres de { $name } : { $pairs } ; il en faut { $least }.
repeats-few-other-frame = Il faut { $least } répétitions sur une autre image ; il y en a { NUMBER($count) }.
repeats-nothing-yet = Pas encore de mesures répétées.
repeats-few = Trop peu de répétitions : { $freedom ->
    [one] { NUMBER($freedom) } degré
   *[other] { NUMBER($freedom) } degrés
 } de liberté, il en faut au moins { $least }.
repeats-few-to-compare = Trop peu de répétitions à comparer : { $freedom }, il en faut au moins { $least }.
repeats-one-operator = Aucune cible n’a été répétée par un second opérateur ; demandez à un autre opérateur d’en répéter.
repeats-no-difference = Aucune différence entre opérateurs n’est détectable ; davantage de répétitions préciseraient l’estimation.
models-none-in-catalogue = Le catalogue est vide.
models-none-of-year = Aucun modèle du catalogue n’a été construit en { $year }.
models-none-fits = Aucun modèle du catalogue ne convient à ce qui a été mesuré sur ce véhicule.
models-nothing-measured = Aucune dimension du catalogue n’a encore été mesurée sur ce véhicule.
models-no-such-size = Aucun modèle du catalogue n’a de dimension mesurée sur ce véhicule.

## Said: what an import notes of a video or of strips

video-filmed-at = Filmé à { $filmed_hz } images par seconde, comme saisi ; le fichier est lu à { $played_hz } par seconde. Les instants sont ceux de la prise de vue.
video-no-rate = Le fichier n’indique aucune cadence : { $played_hz } images par seconde sont supposées. Ses instants ne sont pas fiables ; aucun mouvement n’en est donc mesuré.
video-impossible-rate-endless = Les horodatages donnent une infinité d’images par seconde, ce qu’aucune caméra ne filme. Ses instants ne sont pas fiables ; aucun mouvement n’en est donc mesuré.
video-impossible-rate = Les horodatages donnent { $played_hz } images par seconde, ce qu’aucune caméra ne filme. Ses instants ne sont pas fiables ; aucun mouvement n’en est donc mesuré.
video-slow-motion = Le fichier est marqué comme ralenti ; il est lu à { $played_hz } images par seconde. Les hauteurs d’une seule image sont valables, mais aucun mouvement n’est mesuré tant que vous n’avez pas saisi la cadence de prise de vue.
video-slow-motion-at = Le fichier indique qu’il a été filmé à { $filmed_hz } images par seconde ; il est lu à { $played_hz } images par seconde. Les hauteurs d’une seule image sont valables, mais aucun mouvement n’est mesuré tant que vous n’avez pas saisi la cadence de prise de vue.
video-gaps = Des images manquent : { $count ->
    [one] une lacune
   *[other] { NUMBER($count) } lacunes
 }, la plus longue de { NUMBER($gap_s, minimumFractionDigits: 2, maximumFractionDigits: 2) } s après l’image { $frame }.
video-truncated = Le fichier est tronqué : il manque { NUMBER($missing) } octets à la fin. { NUMBER($count) } images ({ NUMBER($span_s, minimumFractionDigits: 2, maximumFractionDigits: 2) } s) ont été importées ; recopiez-le pour le reste.
video-another-recording-after = Le fichier contient après celui-ci un autre enregistrement, qui n’est pas importé. Scindez le fichier et ajoutez chaque partie.
video-other-tracks = Le fichier contient { $count ->
    [one] une autre piste vidéo
   *[other] { NUMBER($count) } autres pistes vidéo
 } : { $others } ; la piste { $stream } ({ $codec }, { $width_px }x{ $height_px }) a été importée.
video-track = { $number } ({ $codec }, { $width_px }x{ $height_px }{ $kind ->
    [still] , une image fixe
    [off] , désactivée
    [still_off] , une image fixe, désactivée
   *[moving] { "" }
 })
video-track-unknown = { $number } (codec inconnu)
video-not-turned = L’en-tête demande une rotation supplémentaire de { $degrees } degrés, qui n’est pas appliquée : seuls les quarts de tour conservent les pixels tels que filmés.
video-same-image = { NUMBER($count) } { $count ->
    [one] image est identique
   *[other] images sont identiques
 } à la précédente.
video-not-later = { NUMBER($count) } { $count ->
    [one] image a un horodatage qui ne suit pas
   *[other] images ont un horodatage qui ne suit pas
 } celui de la précédente ; les temps ont été triés.
video-packets-damaged = { NUMBER($count) } { $count ->
    [one] paquet endommagé a été ignoré
   *[other] paquets endommagés ont été ignorés
 } ; des images y manquent.
video-frames-patched = { NUMBER($count) } { $count ->
    [one] image est endommagée et complétée
   *[other] images sont endommagées et complétées
 } par le décodeur, la première à { $first } ; n’y mesurez pas.
video-start-in-future = Le fichier indique un début à { $start } UTC, qui est dans le futur : l’horloge de la caméra est fausse ; aucun début n’est donc proposé.
video-ends-early = L’en-tête annonce { NUMBER($duration_s, minimumFractionDigits: 1, maximumFractionDigits: 1) } s, les images s’arrêtent à { NUMBER($end_s, minimumFractionDigits: 1, maximumFractionDigits: 1) } s ; le fichier est peut-être tronqué.
video-other-rate = L’en-tête annonce { $stated_hz } images par seconde, les horodatages { $rate_hz } ; les horodatages font foi.
video-other-count = L’en-tête annonce { NUMBER($claimed) } images, { NUMBER($count) } ont pu être décodées ; les numéros d’image se rapportent à celles-ci.
video-shown-upright = Les images ont été { $done }, comme l’indique leur en-tête.
video-stretched = étirées pour des pixels de { $aspect }
video-turned = tournées de { $degrees } degrés dans le sens horaire
video-mirrored = retournées en miroir
video-interlaced = L’enregistrement est entrelacé : les bords mobiles sont dentelés, préférez un enregistrement progressif.
video-working-copy = Les images viennent d’une copie de travail indexée ; elles sont identiques à celles de l’original.
video-other-size-skipped = { NUMBER($count) } images d’une autre taille ont été ignorées.
video-rate-varies = La cadence d’images varie : { NUMBER($least_s, minimumFractionDigits: 4, maximumFractionDigits: 4) } à { NUMBER($most_s, minimumFractionDigits: 4, maximumFractionDigits: 4) } s entre images ; les temps viennent des horodatages.
video-unreadable-end = Le fichier n’a pu être lu jusqu’au bout ; { NUMBER($count) } images ont été trouvées avant.
video-no-time-stamps = Le flux n’a pas d’horodatage utilisable : { $rate_hz } images par seconde sont supposées, ne vous fiez donc pas à ses temps.
scan-pixels-saturated = { $percent } % des pixels de la caméra { $camera } sont saturés : des bords y sont perdus ; réduisez la lumière ou l’exposition.
scan-recorder-lost = L’enregistreur de { $name } a perdu { NUMBER($count) } lignes ; elles sont remplacées par des copies.
scan-recorder-other-rate = { $name } annonce une cadence de { $told_hz } Hz, mais { $line_rate_hz } Hz ont été donnés et sont utilisés ; vérifiez laquelle est juste.

## Said: how far a job is

job-begun-again = La tâche a été interrompue ; elle est relancée.
job-tried-again = La base de données ou le stockage ne répond pas ; la tâche est relancée automatiquement.
job-waits-to-begin-again = En attente d’être relancée.
job-video-reading = Lecture de la vidéo.
job-drift-searching = Recherche de mouvements de la caméra.
job-drift-background = Recherche du fond dans l’image { $frame }.
job-board-searching = Recherche de la mire.
job-board-searching-frame = Recherche de la mire dans l’image { $frame }.
job-board-searching-in = Recherche de la mire dans { $name }.
job-pose-computing = Calcul de la pose de la caméra.
job-lens-fitting = Ajustement de l’objectif, puis des deux moitiés séparément.
job-export-vehicles = Écriture des véhicules, des vérifications et de la chaîne d’audit.
job-export-measurements = Écriture des mesures.
job-export-crops = Découpe des vues de chaque pointé.
job-export-figures = Calcul des statistiques, tracé des figures et du rapport.
job-export-reading = Lecture du relevé.
job-export-storing = Enregistrement de l’archive.
job-export-packing = Archivage des fichiers.
job-heights-saving = Enregistrement des hauteurs modifiées.
job-heights-restoring = Rétablissement des anciennes hauteurs.
job-heights-computing = Calcul des hauteurs.
job-strips-reading = Lecture des bandes.
job-strips-cutting = Découpe des bandes.
job-vehicles-found = Détection des véhicules. { NUMBER($count) } jusqu’ici.
job-vehicles-again = Nouvelle mesure des véhicules connus.
job-study-package = Écriture de l’archive.
job-study-report = Écriture du rapport.
job-study-figures = Calcul des valeurs.
job-passes-searching = Détection des passages.
job-demo-videos = Lecture des vidéos.
job-demo-poses = Calcul des poses des caméras.
job-demo-site = Simulation d’un site.
job-demo-saving = Enregistrement du relevé de démonstration.

## The words of the standards and of the insets that the program brings, by their codes

standard-name-usa_eye_car = AASHTO (États-Unis)
standard-name-usa_object_stopping = AASHTO (États-Unis)
standard-name-usa_object_passing = AASHTO (États-Unis)
standard-name-usa_eye_truck = AASHTO (États-Unis)
standard-name-usa_headlight = AASHTO (États-Unis)
standard-name-fitzpatrick_vehicle = Fitzpatrick et al. (proposé)
standard-name-usa_2000_eye_car = AASHTO (États-Unis), 2000
standard-name-usa_1965_eye_car = AASHTO (États-Unis), 1965
standard-name-usa_1920_eye_car = AASHTO (États-Unis), 1920
standard-name-uk_eye_car = Royaume-Uni
standard-name-uk_eye_truck = Royaume-Uni
standard-name-uk_object_low = Royaume-Uni, bas
standard-name-uk_object_high = Royaume-Uni, haut
standard-name-italy_eye_car = Italie
standard-name-australia_eye_truck = Australie
standard-name-australia_object_stopping = Australie
standard-name-australia_eye_car = Australie
standard-name-australia_1991_eye_car = Australie, 1991
standard-name-germany_eye_car = Allemagne
standard-name-germany_eye_truck = Allemagne
standard-name-israel_eye_car = Israël
standard-name-israel_object_low = Israël, bas
standard-name-own = valeur personnelle
standard-class-usa_eye_car = voitures particulières
standard-class-usa_object_stopping = feux arrière de voitures particulières
standard-class-usa_eye_truck = camions
standard-class-usa_headlight = projecteurs de voitures particulières
standard-class-fitzpatrick_vehicle = voitures particulières
standard-class-uk_eye_car = conducteurs
standard-class-uk_eye_truck = grands poids lourds, valeur typique
standard-class-france_eye_car = voitures particulières de l’étude de Fambro et al. 1997
standard-class-france_object_stopping = feux arrière, bord inférieur, à une gare de péage près de Paris
standard-class-australia_eye_truck = camions
standard-class-australia_object_stopping = feux arrière de voitures
standard-class-germany_eye_truck = camions
standard-source-usa_eye_car = A Policy on Geometric Design of Highways and Streets (d’après Fitzpatrick, Lienau et Fambro, Transportation Research Record 1612, 1998)
standard-source-usa_object_stopping = A Policy on Geometric Design of Highways and Streets (d’après Fitzpatrick, Lienau et Fambro, Transportation Research Record 1612, 1998)
standard-source-usa_headlight = angles rentrants ; Fitzpatrick, Lienau et Fambro, Transportation Research Record 1612, 1998
standard-source-fitzpatrick_vehicle = Fitzpatrick, Lienau et Fambro, Transportation Research Record 1612, 1998
standard-source-usa_1965_eye_car = le guide AASHTO de l’époque
standard-source-usa_1920_eye_car = premières propositions (1676 mm dans Fitzpatrick et al.)
standard-source-uk_eye_car = Design Manual for Roads and Bridges, TD 9/93 (auj. CD 109)
standard-source-uk_eye_truck = Design Manual for Roads and Bridges, TD 9/93 (auj. CD 109)
standard-source-uk_object_low = Design Manual for Roads and Bridges, TD 9/93 (auj. CD 109) ; Dupuis et al. impriment 0,25 m
standard-source-uk_object_high = Design Manual for Roads and Bridges, TD 9/93 (auj. CD 109) : haut d’une plage
standard-source-italy_eye_car = normes CNR de 1973
standard-source-australia_eye_truck = Austroads, Guide to Road Tunnels Part 2, 4.5.2 (angles rentrants sous plafond)
standard-source-australia_object_stopping = Austroads, Guide to Road Tunnels Part 2, 4.5.2 (feu arrière d’une voiture)
standard-source-australia_1991_eye_car = valeur de conception de l’époque
standard-source-germany_eye_car = RAL (auparavant RAS-L)
standard-source-germany_eye_truck = RAL (auparavant RAS-L)
standard-source-israel_eye_car = directives nationales
standard-source-israel_object_low = directives nationales
standard-source-own = saisie sur la page
standard-cited-usa_eye_car = Dupuis et al., Sensors 2019 ; le centile d’après le résumé de Fitzpatrick et al.
standard-cited-usa_object_stopping = Dupuis et al., Sensors 2019 ; le centile d’après le résumé de Fitzpatrick et al.
standard-cited-usa_eye_truck = une source non consignée
standard-cited-usa_headlight = le résumé de Fitzpatrick et al., qui le recommandent
standard-cited-fitzpatrick_vehicle = le résumé de Fitzpatrick et al.
standard-cited-uk_eye_car = Rogers, Highway Engineering, 2003 : plus de 95 % des yeux des conducteurs sont plus hauts
standard-cited-australia_eye_car = une source non consignée
standard-cited-australia_1991_eye_car = le résumé de Barker et Yue, Australian Road Research 21(2), 1991
standard-cited-germany_eye_car = une source non consignée
standard-cited-germany_eye_truck = une source non consignée
standard-cited-israel_eye_car = une source non consignée
standard-cited-israel_object_low = une source non consignée
inset-note-roof = bord proche du toit ; 0,85 m (u = 0,10 m) pour son sommet (estimation)
inset-note-roof_van = bord proche du toit (estimation)
inset-note-roof_box = caisse à parois verticales (estimation)
inset-note-roof_unknown = comme une voiture, moins certain (estimation)
inset-note-driver_eye_near = conducteur du côté de la caméra (estimation)
inset-note-driver_eye_far = conducteur du côté opposé à la caméra (estimation)
inset-note-taillight = bord extérieur du feu (estimation)
inset-note-headlight = bord extérieur du feu (estimation)
inset-note-other = retrait inconnu

## Ends of jobs and imports; and what things are called in errors, found again by the English (recognised.py)

jobs-cancelled = Annulé.
jobs-gave-up = La tâche s’est arrêtée { $attempts } fois ; contrôlez les données d’entrée et la mémoire disponible.
jobs-broke = Une erreur du programme a arrêté la tâche ({ $name }) ; réessayez, et signalez-la si elle revient.
scans-lines-not-stored = Les lignes de ce flux n’ont pas été enregistrées : il n’y a pas d’image ; ses véhicules restent.
scans-import-cancelled = L’import a été annulé ; relancez-le ou supprimez le balayage.
scan-simulated = Simulé, pour que les valeurs vraies soient connues : marques inventées, une caméra 0,6 px plus bas que l’autre, un jalon tenu vertical dans le plan de la caméra 1 à 2,7 m et à 4,5 m avant le premier véhicule.
told-thing-camera-pose = pose de la caméra
told-thing-line-scan = balayage
told-thing-scanned-vehicle = véhicule balayé
told-thing-calibration-image = photo d’étalonnage
told-thing-tyre-contacts = paire de contacts de pneus
told-thing-catalogue-row = ligne du catalogue


## Application : la visite de la démonstration

tour-title = Visite de la démonstration
tour-offer = Première fois ici ? La visite montre les pages de la démonstration en deux minutes.
tour-take = Faire la visite
tour-not-now = Plus tard
tour-none = Il n’y a pas de démonstration ici. Créez-la sur la page d’accueil, puis faites la visite.
tour-step = Visite, { $step } sur { $of } : { $page }
tour-next = Suivant
tour-back = Retour
tour-skip = Passer la visite
tour-end = Finir la visite
tour-survey = Un relevé mesure les hauteurs des yeux des conducteurs et des feux sur un site. Cette liste indique ce qui est fait et ce qui vient ensuite ; les pages à gauche suivent l’ordre du travail.
tour-recordings = Un enregistrement est une vidéo prise du bord de la route. Chacun indique sa luminosité, son début, et si la caméra a bougé.
tour-pose = Une mire de dimensions connues posée sur la route donne la position de la caméra et l’incertitude attendue des hauteurs.
tour-measure = Choisissez un véhicule et cliquez deux fois sur une image : là où un pneu touche la chaussée, et sur l’œil, le feu ou le toit. La hauteur apparaît aussitôt, avec son U95 et son bilan d’incertitude.
tour-review = Une autre personne valide, corrige ou rejette chaque hauteur. Personne ne vérifie ses propres mesures.
tour-statistics = Seules les hauteurs validées comptent : leurs distributions, les erreurs par rapport aux hauteurs connues, et les centiles des normes aujourd’hui.
tour-export = Un bouton crée l’archive pour un organisme de normalisation : rapport, tableaux, figures et journal d’audit. Son destinataire peut la contrôler. Vous pouvez relancer la visite depuis le menu sous vos initiales.

## Rapport : les mots de tout rapport (PDF). Un rapport est écrit dans la langue dans laquelle il a été demandé.

report-kind = Rapport de mesure
report-of-survey = { $survey }, rapport de mesure
report-survey = Relevé
report-foot = État au { $moment }
report-foot-head = État au { $moment }, tête d’audit du relevé { $head }…
report-empty-trail = journal d’audit vide
report-page = Page { $page } sur { $pages }
report-between = { $low } à { $high }
report-of-all = { NUMBER($part) } sur { NUMBER($all) }
report-decimal-sign = ,
report-date = { $day }/{ $month }/{ $year }
report-minute = { $day }/{ $month }/{ $year } { $time }
report-moment = { $day }/{ $month }/{ $year } à { $time } UTC
report-unit-m = mètres
report-unit-ft = pieds
report-unit-mm = millimètres
report-unit-in = pouces
report-unit-cm2 = centimètres carrés
report-unit-in2 = pouces carrés
report-target-driver_eye = œil du conducteur
report-target-taillight = feu arrière, bord inférieur
report-target-headlight = projecteur
report-target-roof = toit
report-target-other = autre
report-measured-by-other = autre
report-category-other = autre
report-target-roof_van = toit, fourgons
report-target-roof_box = toit, camions et bus
report-target-roof_unknown = toit, sans classe
report-target-driver_eye_near = œil du conducteur, conducteur côté proche
report-target-driver_eye_far = œil du conducteur, conducteur côté éloigné
report-many-driver_eye = yeux des conducteurs
report-many-taillight = bords inférieurs des feux arrière
report-many-headlight = projecteurs
report-many-roof = toits
report-light-daytime = de jour
report-light-low_light = faible luminosité
report-light-overall = ensemble
report-light-unknown = luminosité inconnue
report-measured-by-counter = compteur du véhicule
report-measured-by-radar = radar
report-measured-by-laser = cinémomètre laser
report-measured-by-gps = GPS
report-measured-by-loop = boucle
report-measured-by-tape = mètre ruban
report-category-hatchback = voiture à hayon
report-category-saloon = berline
report-category-estate = break
report-category-suv = SUV
report-category-multi_purpose = monospace
report-category-pickup = pick-up
report-category-van = fourgon
report-category-lorry = camion
report-category-tractor_unit = tracteur routier
report-category-bus = bus ou autocar
report-category-recreational_vehicle = camping-car
report-category-trailer = remorque ou caravane
report-category-motorcycle = motocyclette
report-heading-right = vers la droite
report-heading-left = vers la gauche
report-set-passenger_cars = voitures particulières
report-set-light_trucks = utilitaires légers et monospaces
report-set-heavy = poids lourds
report-divided-by-class_set = groupe de classes
report-divided-by-category = classe
report-divided-by-site = site
report-divided-by-lighting = luminosité
report-divided-by-stratum = strate
report-divided-by-operator = opérateur
report-excluded-as-rejected = rejetée
report-excluded-as-withdrawn = retirée
report-excluded-as-not_measurable = non mesurable
report-excluded-as-to_review = à vérifier
report-excluded-as-not_selected = non choisie
report-excluded-as-check_target = cible de contrôle
report-excluded-as-out_of_sample = hors échantillon
report-filmed-since = filmé à partir du { $day }
report-filmed-until = filmé jusqu’au { $day }
report-filmed-hours = filmé entre { $begins } et { $ends }
report-filmed-nights = { $days ->
    [one] filmé dans la nuit qui commence le { $first }, de { $begins } à { $ends }
    [since] filmé dans les nuits qui commencent à partir du { $first }, de { $begins } à { $ends }
    [until] filmé dans les nuits qui commencent jusqu’au { $last }, de { $begins } à { $ends }
   *[several] filmé dans les nuits qui commencent du { $first } au { $last }, de { $begins } à { $ends }
}
report-lacking = { $mark } remplace les caractères d’une écriture que les polices de ce rapport n’ont pas ; les fichiers CSV les contiennent.
report-check-title = Comment contrôler ce rapport
report-median = Médiane
report-mean = Moyenne
report-sd = Écart-type
report-standard = Norme
report-vehicles = Véhicules
report-target = Cible
report-verdict = Conclusion
report-figure = Grandeur
report-lighting = Luminosité
report-camera = Caméra
report-board = Mire
report-pose = Pose
report-recording = Enregistrement
report-value = Valeur
report-source = Source
report-bias = Biais
report-interval = Intervalle à 95 %
report-interval-total = 95 %, total

## Rapport : le titre

report-days-none = rien encore
report-days = du { $first } au { $last }
report-more-versions = et { NUMBER($n) } autres (voir measurements.csv)
report-verdicts-of = { NUMBER($individual) } validées par une décision individuelle, { NUMBER($by_lot) } par l’échantillon de leur lot. Parmi les { NUMBER($of) } non vérifiées individuellement dans { $lots ->
    [one] { NUMBER($lots) } lot accepté
   *[other] { NUMBER($lots) } lots acceptés
 }, { $estimate } sont fausses d’après l’estimation et { $at_most } au plus (95 % unilatéral).
report-only = <strong>Uniquement :</strong> { $selection }. Les résultats ne comprennent pas les autres véhicules du relevé.
report-filmed = Filmé
report-filmed-unconfirmed = début non confirmé
report-measured = Mesuré
report-place = Lieu
report-in-this = Dans ce rapport
report-in-this-of = { $measurements ->
    [one] { NUMBER($measurements) } mesure
   *[other] { NUMBER($measurements) } mesures
 } de { $vehicles ->
    [one] { NUMBER($vehicles) } véhicule
   *[other] { NUMBER($vehicles) } véhicules
 }, dont { NUMBER($with_reference) } avec une hauteur de référence. Mesures validées seulement.
report-verdicts = Décisions
report-state-of = État au
report-code = Programme
report-count-recordings = enregistrements du relevé
report-count-vehicles = véhicules du relevé, y compris les écartés
report-count-measurements = mesures du relevé, y compris les retirées
report-count-not-visible = cibles non visibles, sur les véhicules comptés
report-count-used = mesures comptées dans les résultats
report-count-left-out = mesures du relevé exclues
report-count-out-of-date = périmées parmi les mesures comptées (out_of_date en donne le motif dans les tableaux)
report-count-without-time = véhicules exclus, car l’heure de prise de vue n’est pas connue
report-count-scanned = véhicules balayés
report-count-scanned-used = dont validés
report-span = { $day } de { $first } à { $last } ({ $zone })
report-unconfirmed = { $n ->
    [one] { NUMBER($n) } enregistrement dont le début n’est pas confirmé
   *[other] { NUMBER($n) } enregistrements dont le début n’est pas confirmé
 }
report-coordinates = { $latitude } ; { $longitude } (WGS84)
report-limit = limitée à { $speed }
report-lamps = éclairage public
report-no-lamps = sans éclairage public

## Rapport : installation, étalonnage, pose de la caméra

report-setup = Installation
report-no-photo = Il n’y a pas de photo de l’installation.
report-photo-broken = La photo « { $caption } » ne peut être lue comme PNG ou JPEG.
report-no-recording = Il n’y a pas d’enregistrement.
report-recordings = Enregistrements. recordings.csv contient le SHA-256 complet de chaque fichier.
report-filmed-from = Filmé à partir de
report-picture = Taille d’image
report-frames = Images
report-duration = Durée
report-model-brown = modèle radial et tangentiel de Brown
report-model-fisheye = fisheye équidistant (Kannala et Brandt)
report-from-images = à partir de photos d’une mire
report-from-clip = à partir d’une vidéo d’une mire
report-from-import = importé du fichier d’un autre outil
report-lens = { $camera }, étalonnage { $number }
report-made = Établi
report-pixels = { $width } × { $height } pixels
report-lens-model = Modèle d’objectif
report-views = Vues
report-views-used = { $used } sur { $given } utilisées
report-residual = Résidu
report-residual-is = { $rms } px (erreur quadratique moyenne de reprojection)
report-trusted = fiable
report-not-trusted = non fiable ; voir les avertissements
report-lens-known = Objectif de { $camera } : paramètres et incertitudes-types.
report-lens-unknown = Objectif de { $camera } : paramètres ; leurs incertitudes sont inconnues.
report-board-of = { $columns } × { $rows } coins intérieurs, cases de { $square } mm
report-board-stood = { $n ->
    [one] Pose
   *[other] Poses
 } { $poses } : rangée de coins de référence à { $height } au-dessus de la route{ $u_height }{ $u_lean }.
report-board-u-height = , u = { $u }
report-board-u-lean =  ; inclinaison et roulis de la mire, u = { $u } mrad chacun
report-poses = Poses de la caméra
report-poses-caption = Poses de la caméra. « { $sign } » : U95 attendue d’une hauteur de 1,2 m pointée à 1 px près, sans la part du retrait, selon la distance à la caméra. Résidu : erreur quadratique moyenne de reprojection des coins de la mire.
report-pose-at = { $sign } à { $distance }
report-above-road = { $unit } au-dessus de la route
report-away = à { $unit }
report-frames-of = images { $first } à { $last }
report-calibration-of = étalonnage { $number }
report-no-board = aucune : la pose a été importée
report-pose-warning = Pose { $pose } : { $words }
report-calibration = Étalonnage et pose de la caméra
report-no-calibration = Aucune mesure n’utilise encore d’étalonnage.
report-no-pose = Aucune mesure n’utilise encore de pose de la caméra.

## Rapport : échantillon et réponse

report-every = Chaque passage est mesuré
report-nth = Un passage sur { $step } est mesuré, à partir du numéro { $start }
report-share-drawn = Une part aléatoire de { $share } % des passages (graine { $seed }) est mesurée
report-rule = { $rule }.
report-rule-free = { $rule }, pour les véhicules dont le temps intervéhiculaire est d’au moins { $seconds } s.
report-set-all = tous
report-set-none = aucun groupe
report-set-unknown = inconnue
report-vehicle = véhicule
report-response = Échantillon et réponse
report-response-words = { $rule } Chaque passage de l’échantillon est mesuré, non visible pour un motif indiqué, ou encore à faire ; un passage écarté n’est pas un véhicule à mesurer. Si le taux diffère entre groupes, les véhicules mesurés peuvent ne pas représenter le trafic.
report-no-pass = Aucun passage n’a été trouvé.
report-response-table = Réponse. Taux : passages (ou cibles) mesurés rapportés à ceux de l’échantillon, avec son intervalle exact à 95 %.
report-classes = Classes
report-of = De
report-passes = Passages
report-discarded = Écartés
report-outside = Hors éch.
report-in-sample = Retenus
report-not-visible = Non visibles
report-open = À faire
report-rate = Taux
report-outside-sample = { $counts ->
    [yes] { $n ->
        [one] { NUMBER($n) } passage a été mesuré bien que hors de l’échantillon, et compte dans les résultats.
       *[other] { NUMBER($n) } passages ont été mesurés bien que hors de l’échantillon, et comptent dans les résultats.
     }
   *[no] { $n ->
        [one] { NUMBER($n) } passage a été mesuré hors de l’échantillon et ne compte pas dans les résultats.
       *[other] { NUMBER($n) } passages ont été mesurés hors de l’échantillon et ne comptent pas dans les résultats.
     }
 }

## Rapport : la méthode

report-method = Méthode
report-method-lead = Les hauteurs sont mesurées comme le proposent Dupuis et al. (Sensors 2019, 19(7), 1611, « l’article »), les fautes d’impression de ses équations étant corrigées (ci-dessous). Un damier de dimensions connues, posé sur la route, donne la pose de la caméra ; deux pointés sur une même image, là où un pneu touche la route et sur la cible, donnent une hauteur. Le repère de la route a X dans le sens du trafic, Y en travers, en s’éloignant de la caméra, et Z vers le haut. Un point { $point } de la route se voit au pixel
report-method-lens = où { $pose } est la pose, { $distortion } la distorsion de l’objectif (modèle radial et tangentiel de Brown, ou fisheye équidistant), et où { $matrix } contient les focales et le point principal. Un pointé { $click } est converti en une direction dans le repère de la route, depuis le centre { $centre } de la caméra :
report-method-rays = Le rayon du contact rencontre la route, { $road }. Le rayon de la cible rencontre le plan vertical, parallèle au trafic, qui se trouve au retrait { $inset } derrière le contact. Avec une pente pour chaque pointé,
report-eq-contact = contact
report-eq-target = cible
report-method-height = la distance { $distance } de la caméra au plan du contact et la hauteur { $height } sont
report-method-inset = L’article suppose { $inset }. Une cible à { $height } est alors lue trop haut de
report-method-raw = 44 mm pour un œil à 1,16 m, à 0,45 m en retrait, à 3 m d’une caméra haute de 1,5 m. Les hauteurs sont donc données deux fois : non corrigées (« brutes ») avec { $inset }, pour la comparaison avec l’article, et corrigées du retrait ci-dessous. Quand les deux mêmes points ont été pointés sur plusieurs images d’un passage, le retrait est estimé avec la hauteur par moindres carrés.
report-method-u = L’incertitude-type de chaque hauteur s’obtient par propagation linéaire (JCGM 100:2008),
report-coverage-factor = 1,96
report-method-u-over = pour les deux pointés, l’objectif et la pose (ensemble, avec leur covariance), l’inclinaison, le roulis, la hauteur au-dessus de la route, le côté des cases et la flèche de la mire, et le retrait. La même pose sert à de nombreux véhicules : son erreur est commune à toutes leurs hauteurs.
report-assumed = Hypothèses
report-assumed-plane = La route est plane de la mire au véhicule, et la mire lui était perpendiculaire, à son incertitude près.
report-assumed-still = La caméra n’a pas bougé entre l’enregistrement de la mire et les mesures qui l’utilisent.
report-assumed-parallel = Les véhicules roulent parallèlement aux rangées de la mire ; leurs flancs sont verticaux au contact.
report-assumed-inset = Le retrait d’une cible est celui de la liste ci-dessous, à son incertitude près, sauf s’il a été estimé à partir de plusieurs images.
report-assumed-makers = Les hauteurs des constructeurs sont celles du véhicule tel qu’il est passé, à leur incertitude près.
report-assumed-left-out = Non compris : un modèle d’objectif inadapté, la charge et la suspension, les variations de dévers entre la mire et le véhicule.
report-misprinted = Fautes d’impression de l’article
report-misprints = Équations de l’article, telles qu’imprimées et telles qu’utilisées ici.
report-equation = Équation
report-as-printed = Imprimée
report-as-used = Employée
report-used-3 = la distorsion agit après la division par la profondeur, équation (1)
report-used-4 = c’est le pixel que l’on corrige de la distorsion, équation (2)
report-used-5 = les directions tournent et ne sont pas décalées, { $used }
report-used-8 = correct seulement si { $down } pointe vers le bas ; les coins sont d’abord rangés dans cet ordre
report-used-10 = une ligne : { $used }
report-used-13 = { $printed } n’est pas défini ; il s’agit de la normale { $used } du plan latéral
report-used-14 = { $used }, sinon le plan latéral est inversé
report-used-17 = { $used }, avec le point de contact métrique
report-used-18 = la distance signée au plan de la route, { $used }
report-insets = Retraits en vigueur : distance d’une cible derrière le plan du contact, et son incertitude-type.
report-inset = Retrait ({ $unit })
report-from = Source

## Rapport : les équations lues à voix haute

report-aloud-pixel = p = K d(pi(R x + t)), pi(x, y, z) = (x sur z, y sur z)
report-aloud-ray = m = d inverse de K inverse p, w = R transposée (m x, m y, 1), C = moins R transposée t
report-aloud-slopes = s = w y sur w z au contact, q = w z sur w y à la cible
report-aloud-height = D = moins C z s, h = C z + (D + delta) q
report-aloud-inset = b = (C z moins h) delta sur (D + delta)
report-aloud-u = u carré de h = somme sur i de (dh par dx i) au carré, u carré de x i, U 95 = 1,96 u de h
report-aloud-4 = p = d inverse de K inverse P
report-aloud-10 = P g = moins n x d
report-aloud-10-used = moins n x transposé, d
report-aloud-13 = P c = moins C x d
report-aloud-14 = d = n z transposé p l
report-aloud-14-used = d = moins n z transposé p l
report-aloud-17 = n x p prime l sur n x p prime h
report-aloud-17-used = n z transposé p l sur n z transposé p prime h
report-aloud-18 = p h transposé P g sur moins n x
report-aloud-18-used = n x transposé (X g moins p h)

## Rapport : les résultats en bref

report-glance = Les résultats en bref
report-brackets = (95 % : { $interval })
report-conclusion = Conclusion
report-filmed-on = Filmé : { $moment }
report-not-covered = Non couvert
report-concluded-of = { $measurements ->
    [one] { NUMBER($measurements) } hauteur validée
   *[other] { NUMBER($measurements) } hauteurs validées
 } de { $vehicles ->
    [one] { NUMBER($vehicles) } véhicule
   *[other] { NUMBER($vehicles) } véhicules
 }, mesurées sur vidéo depuis le bord de la route.
report-concluded-rule = P{ $percent } : { $of } ({ $classes }, n = { NUMBER($n) }) : { $value }{ $interval }. { $standard } retient { $limit } : { $verdict }.
report-concluded-none = P{ $percent } : { $of } ({ $classes }, n = { NUMBER($n) }), non déterminé : { $reason }.
report-uncovered-selection = Les véhicules hors des limites de cette archive, qui contient seulement : { $selection }.
report-uncovered-classes = Les classes de véhicules : pour certaines cibles, aucune classe n’est connue ; leurs valeurs portent sur tous les véhicules.
report-uncovered-excluded = { $n ->
    [one] 1 mesure est exclue ; le tableau des exclusions en donne la raison.
   *[other] { NUMBER($n) } mesures sont exclues ; le tableau des exclusions en donne les raisons.
 }
report-uncovered-not-visible = { $n ->
    [one] 1 cible n’était pas visible.
   *[other] { NUMBER($n) } cibles n’étaient pas visibles.
 }
report-uncovered-out-of-date = { $n ->
    [one] 1 hauteur n’est plus à jour : des données dont elle dépend ont été modifiées après son calcul. Elle est incluse sans changement.
   *[other] { NUMBER($n) } hauteurs ne sont plus à jour : des données dont elles dépendent ont été modifiées après leur calcul. Elles sont incluses sans changement.
 }
report-uncovered-line-heights = { $n ->
    [one] 1 hauteur validée de balayages : elle figure dans la section sur les balayages.
   *[other] { NUMBER($n) } hauteurs validées de balayages : elles figurent dans la section sur les balayages.
 }
report-uncovered-by-lot = { $n ->
    [one] 1 hauteur validée n’a pas été vérifiée individuellement : l’échantillon de son lot l’a été.
   *[other] { NUMBER($n) } hauteurs validées n’ont pas été vérifiées individuellement : les échantillons de leurs lots l’ont été.
 }
report-uncovered-others = Autres routes, autres jours, autre trafic : les intervalles valent pour le trafic qui passe sur ce site.
report-readme-contents = Contenu de cette archive
report-readme-page = Cette archive sous forme de page : à ouvrir dans un navigateur. Elle se vérifie elle-même, sans serveur.
report-readme-report = Le rapport.
report-readme-statistics = Les valeurs du rapport en tableaux, non arrondies.
report-readme-tables = Chaque véhicule, mesure et vérification en tableaux ; datapackage.json décrit chaque colonne.
report-readme-files = Images, figures, poses et étalonnages des caméras, et les mêmes tableaux en Parquet.
report-readme-audit = La chaîne d’audit et sa signature.
report-readme-check = Pour tout vérifier : sightline verify, avec la clé qu’affiche l’installation. Pour vérifier qu’aucun fichier n’a changé : sha256sum -c SHA256SUMS
report-error-none = Aucun véhicule n’a de hauteur de référence : les erreurs des hauteurs ne peuvent pas être indiquées.
report-error-short = Par rapport aux hauteurs de référence de { $n ->
    [one] { NUMBER($n) } véhicule
   *[other] { NUMBER($n) } véhicules
 }, les toits sont mesurés avec une erreur absolue moyenne de { $mae }{ $mae_interval } et un biais de { $bias }{ $bias_interval }.
report-rules = Normes : le même centile aujourd’hui. Le centile sur lequel repose une norme, avec son intervalle total à 95 %. « Plus bas » ou « plus haut » est indiqué si le risque d’erreur est d’au plus 2,5 % (JCGM 106).
report-rule-column = Règle
report-today = Aujourd’hui
report-difference = Différence
report-no-verdict = pas de conclusion : { $reason }
report-alike = indécis ; plus bas avec une probabilité de { $percent }
report-lower = plus bas (risque d’erreur { $risk })
report-higher = plus haut (risque d’erreur { $risk })
report-less-than = moins de { $percent }

## Rapport : l’erreur par rapport aux hauteurs de référence

report-errors = Erreur par rapport aux hauteurs de référence
report-errors-none = Aucune hauteur de toit validée n’a de hauteur de référence : les erreurs ne peuvent pas être indiquées. Saisissez la hauteur du constructeur dans les fiches des véhicules.
report-errors-holds = Les intervalles à 95 % comprennent { $holds }. Ceux des corrélations, de l’asymétrie et des droites de régression ne comprennent que l’échantillonnage.
report-errors-words = Erreur = mesure moins référence, pour les toits corrigés de leur retrait, sans arrondi. Toutes les valeurs sont calculées à partir des erreurs individuelles, jamais à partir d’autres valeurs.
report-errors-table = Erreurs avec leurs intervalles de confiance à 95 %.
report-row-bias = Biais (erreur moyenne)
report-row-sd = Écart-type de l’erreur
report-row-r = r(erreur, hauteur)
report-row-r-abs = r(|erreur|, hauteur)
report-row-skewness = Asymétrie de l’erreur
report-row-within = Part d’erreurs ≤ { $limit } cm
report-no-group = Aucun véhicule validé avec une hauteur de référence : { $group }.
report-reference-part = { $words } Cela suffit à produire une corrélation de { $correlation } entre l’erreur et la hauteur, indépendamment de la caméra (u de la référence : { $u }).
report-limits = Limites de concordance (Bland et Altman) : { $lower } ({ $lower_interval }) et { $upper } ({ $upper_interval }).
report-as-in-the-paper = Comme dans l’article
report-as-in-the-paper-words = Seulement pour la comparaison avec Dupuis et al. (Sensors 2019, 19(7), 1611). Comme dans l’article : retrait 0 et, pour les erreurs, les deux hauteurs arrondies au centimètre. Les centiles sont ceux des hauteurs mesurées, erreur aléatoire comprise ; leurs intervalles ne couvrent que l’échantillonnage. Aucune autre section n’utilise ces valeurs.
report-paper-errors = Erreurs comme dans l’article : retrait 0, centimètres entiers, avec leurs IC à 95 %.
report-paper-percentiles = Centiles comme dans l’article, des hauteurs ({ $target }) ; véhicules : { $raw } non corrigés, { $corrected } corrigés.
report-paper = Tableau 1 de l’article, tel qu’imprimé.
report-its-column = Sa colonne
report-inconsistent = Incohérences
report-known-errors = Erreurs par cible, luminosité et classe : mesure moins hauteur connue, sans arrondi, avec des intervalles totaux à 95 %. Les cibles de contrôle sont exclues partout ailleurs.
report-within-u95 = Dans leur U95
report-check-errors = Cibles de contrôle : mesure moins hauteur relevée au mètre ruban, avec des intervalles totaux à 95 %.
report-known-errors-note = Les intervalles comprennent les erreurs communes aux hauteurs (pose, retrait moyen). Un modèle choisi d’après ses dimensions ne sert pas de référence.
report-check-targets = { $target }, cibles de contrôle

## Rapport : les distributions des hauteurs

report-heights = Distributions des hauteurs
report-heights-none = Pas encore de hauteurs validées.
report-percentiles = Hauteurs vraies ({ $target }), toutes classes comprises, avec intervalles totaux à 95 % ; véhicules : { NUMBER($n) }.
report-holds = Hauteurs vraies : l’erreur de mesure aléatoire est retirée de la dispersion. Les intervalles totaux comprennent { $holds }.
report-absent = Aucune hauteur validée : { $targets }.
report-percentile = Centile
report-true-heights = Hauteurs vraies
report-corrected = Corrigées
report-interval-sampling = 95 %, échantil­lonnage
report-raw-inset = Non corrigées, retrait 0
report-reason-of = { $percents } : { $reason }.
report-shares = Normes, et part qui leur est inférieure (des hauteurs vraies) : { $targets }, avec des intervalles totaux à 95 %.
report-height = Hauteur
report-below = Au-dessous (mesurées)
report-share = Part
report-not-corrected-why = Non corrigées : { $reason }
report-percentile-of = P{ $percent }, { $of }
report-cited-by = citée d’après { $who }, texte non consulté
report-lateral = Positions latérales
report-lateral-words = Distance du contact du pneu à la caméra, mesurée en travers de la route : une valeur par véhicule, la médiane de ses contacts. Une voie regroupe les véhicules qui vont dans le même sens sur l’image.
report-lateral-table = Positions latérales par voie et par classe.
report-lateral-all = Toutes

## Rapport : la distance de visibilité

report-sight = Distance de visibilité
report-sight-words = Un angle saillant assure une distance de visibilité S si la longueur de son raccordement par pour cent de déclivité, K, est d’au moins S²/C. C ne dépend que des hauteurs de l’œil et de l’obstacle : C = 100 (√(2 œil) + √(2 obstacle))². La norme est { $standard } (œil { $eye }, obstacle { $object }). Les hauteurs du relevé sont le centile { $eye_percent } des yeux et le centile { $object_percent } des bords inférieurs des feux arrière, { $classes }{ $rule ->
    [own] , règle de cette norme d’après ses sources
   *[usual] , et là où la norme ne donne pas de règle, celle des hauteurs de l’AASHTO
 }. S est la distance de visibilité d’arrêt ({ $source }), arrondie par excès comme dans les tables de conception.
report-sight-missing = Il n’y a pas d’angle saillant pour les hauteurs du relevé : aucune hauteur validée pour { $targets } dans la classe que nomme la règle.
report-sight-table = K des angles saillants d’après les hauteurs de la norme et celles du relevé, en { $unit } par pour cent.
report-design-speed = Vitesse de référence
report-stopping = Distance d’arrêt
report-k-standard = K, norme
report-k-survey = K, relevé
report-per-percent = { $unit } par %
report-sight-note = Intervalles totaux des deux centiles de hauteurs vraies (échantillonnage, erreurs communes aux hauteurs, erreur aléatoire) ; les erreurs dues à la même pose de caméra sont communes aux deux et comptées ensemble (limites de Zou et Donner, 2008). La réaction et le freinage du conducteur sont des conventions de la norme, sans intervalle.

## Rapport : les balayages

report-scans = Balayages
report-scans-words = Deux caméras linéaires, séparées d’une base connue, enregistrent le même trafic (Douxchamps, Macq et Chihara). Le mouvement d’un véhicule est une vitesse quand son avant atteint la caméra 1 et une accélération constante ; sa longueur est corrigée de l’accélération. Les intervalles temporels vont de l’arrière du véhicule précédent à cet avant, les distances intervéhiculaires séparent les mêmes points quand cet avant atteint la caméra 1. { $methods }Les incertitudes comprennent la base, l’horloge, le désalignement, l’ajustement et les bornes.
report-scans-methods = Méthode : { $methods }.
report-and = { $first } et { $last }
report-apart = { $first } ; { $second }
report-scans-direct = { $n ->
    [one] { NUMBER($n) } véhicule par recalage de ses deux bandes entières (recalage direct)
   *[other] { NUMBER($n) } véhicules par recalage de leurs deux bandes entières (recalage direct)
 }
report-scans-paper = { $n ->
    [one] { NUMBER($n) } véhicule par l’appariement de blocs et la régression linéaire de l’article
   *[other] { NUMBER($n) } véhicules par l’appariement de blocs et la régression linéaire de l’article
 }
report-rigs = Balayages et leurs dispositifs tels que saisis ; u est l’incertitude-type.
report-line-scan = Balayage
report-lines = Lignes
report-baseline = Base
report-line-rate = Cadence
report-clock = Horloge
report-divergence = Divergence
report-lane-distance = Distance à la voie
report-misalignment = Désalignement
report-video-columns = colonnes d’une vidéo, { $lighting }
report-strips = bandes, { $lighting }
report-from-traffic = d’après le trafic
report-with-u = { $value } (u = { $u })
report-no-vehicle = Ils ne contiennent aucun véhicule.
report-left-out-to-review = { NUMBER($n) } non encore vérifiés
report-left-out-rejected = { NUMBER($n) } rejetés
report-left-out-not-measurable = { NUMBER($n) } non mesurables
report-none-accepted = Aucun véhicule balayé n’est validé.
report-accepted-count = { $n ->
    [one] { NUMBER($n) } véhicule validé, sur { NUMBER($all) } détectés.
   *[other] { NUMBER($n) } véhicules validés, sur { NUMBER($all) } détectés.
 }
report-scans-left-out = Exclus : { $states } ; scan_vehicles.csv en donne les motifs.
report-speed-short = Vitesse moyenne : { $mean } ; vitesse du 85e centile (V85) : { $p85 } { $interval }.
report-no-interval = (pas d’intervalle à 95 % : { $reason })
report-quantities = Grandeurs mesurées des véhicules validés : centiles avec intervalles à 95 %.
report-quantity = Grandeur
report-quantity-of-speed = vitesse
report-quantity-of-length = longueur
report-quantity-of-wheelbase = empattement
report-quantity-of-time_gap = intervalle temporel
report-quantity-of-distance_gap = distance intervéhiculaire
report-quantity-of-headway = temps intervéhiculaire
report-by-lengths = Base d’après les longueurs : { $reason }
report-by-wheelbases = Base d’après les empattements : { $reason }
report-over-lengths = Longueurs mesurées sur longueurs connues de { $n ->
    [one] { NUMBER($n) } véhicule
   *[other] { NUMBER($n) } véhicules
 } : { $ratio } (u = { $u }). { $verdict }
report-over-wheelbases = Empattements mesurés sur empattements connus de { $n ->
    [one] { NUMBER($n) } véhicule
   *[other] { NUMBER($n) } véhicules
 } : { $ratio } (u = { $u }). { $verdict }
report-baseline-agrees = Le rapport s’écarte de 1 de moins de 2 u : il est compatible avec la base.
report-sizes-none = Aucun véhicule validé n’a de longueur ni d’empattement connus : leurs erreurs ne peuvent pas être indiquées.
report-sizes = Erreurs (mesure moins dimensions du constructeur) en { $unit }, avec des intervalles à 95 %.
report-sizes-scatter = Les intervalles ne reflètent que la dispersion de ces erreurs, sans l’erreur de la base, commune à tous les véhicules.
report-size = Dimension
report-references = Écarts (mesure moins référence) des véhicules validés par rapport aux mesures de référence, par source. Accord : |E<sub>n</sub>| d’au plus 1, soit un écart inférieur à l’U95 composée des deux (ISO 13528), avec l’intervalle à 95 % de la part.
report-reference = Référence
report-all-sources = toutes sources
report-within = Accord
report-share-within = Part en accord
report-references-words = Environ 95 % devraient être en accord. Les véhicules d’un même dispositif partagent l’erreur de sa base : plusieurs peuvent être en désaccord en même temps. scan_references.csv contient toutes les valeurs de référence.
report-scan-heights = Hauteurs validées de véhicules balayés au-dessus de la chaussée, par deux pointés dans la bande de la caméra 1, dont la pose a été étalonnée avec un jalon ; corrigées de leurs retraits. Chacune a sa propre décision ; les hauteurs en attente de vérification sont exclues.
report-typical-u95 = U95 typique
report-waiting = En attente
report-table-1 = Véhicules validés, présentés comme le tableau I de l’article.
report-vehicle-column = Véhicule
report-speed-column = Vitesse
report-acceleration = Accélération
report-length-column = Longueur
report-true-length = Longueur connue
report-length-error = Erreur de longueur
report-fit-error = Erreur d’ajustement
report-first-of = Les { NUMBER($shown) } premiers sur { NUMBER($all) } ; scan_vehicles.csv les contient tous.

## Rapport : ce qui a été écarté, comment contrôler

report-left-out = Exclusions
report-nothing-left-out = Aucune mesure n’est exclue.
report-left-out-of = { $n ->
    [one] { NUMBER($n) } mesure est exclue des résultats.
   *[other] { NUMBER($n) } mesures sont exclues des résultats.
 } Toutes sont listées dans les fichiers CSV de l’archive.
report-left-out-first = { $n ->
    [one] { NUMBER($n) } mesure est exclue des résultats.
   *[other] { NUMBER($n) } mesures sont exclues des résultats.
 } Les { NUMBER($shown) } premières figurent ici. Toutes sont listées dans les fichiers CSV de l’archive.
report-left-out-table = Mesures exclues des résultats, avec le motif.
report-number = Numéro
report-state = État
report-reason = Motif
report-check-words = Ce rapport fait partie d’une archive de fichiers CSV et JSON. La commande ci-dessous contrôle les empreintes et le journal d’audit de l’archive, et recalcule chaque hauteur à partir des pointés, de la pose et de la caméra, et chaque statistique à partir des lignes. Colonnes, unités et significations sont décrites dans datapackage.json.
report-package = ARCHIVE
report-trail-empty = Le journal d’audit est vide.
report-trail = Le journal d’audit a { $n ->
    [one] { NUMBER($n) } événement
   *[other] { NUMBER($n) } événements
 } jusqu’au dernier de ce relevé. Chacun porte l’empreinte du précédent ; quiconque a gardé ailleurs l’empreinte de cet événement peut vérifier que rien avant lui n’a été modifié depuis. Cette empreinte est la tête d’audit du relevé, donnée ci-dessous et au pied de chaque page. L’événement suivant, qui scelle cette archive, nomme chaque fichier par son empreinte. Sa propre empreinte est la tête d’audit de l’archive, donnée là où celle-ci a été créée.
report-checksums = SHA-256 des fichiers de l’archive.
report-file = Fichier

## Rapport : les figures

report-fig-cumulative = Hauteurs, répartition : { $target }
report-fig-no-height = Aucune hauteur validée : { $target }.
report-fig-corrected = corrigées, n = { $n }
report-fig-height-above = Hauteur au-dessus de la route : { $target } ({ $unit })
report-fig-height = Hauteur : { $target } ({ $unit })
report-fig-share = Part des véhicules (%)
report-fig-share-below = { $standard }, { $share } au-dessous
report-fig-cumulative-caption = Toutes classes comprises. Trait plein : hauteurs corrigées de leur retrait. Points : centiles des hauteurs vraies avec leurs intervalles totaux à 95 %. Les parts sous les normes sont, elles aussi, celles des hauteurs vraies.
report-fig-density = Hauteurs, densité : { $target }
report-fig-density-axis = Densité (par { $unit })
report-fig-density-caption = Hauteurs corrigées, n = { $n } ; noyau gaussien, largeur de bande { $width }.
report-fig-by = Hauteurs par { $grouping } : { $target }
report-fig-by-caption = Hauteurs corrigées par groupe (nombre de véhicules) : médiane (anneau), 15e au 85e centile (épais), 5e au 95e (fin) ; chaque véhicule (trait) s’ils sont trop peu nombreux.
report-fig-band = Bande : 95 %, simultanée, échantillonnage seul.
report-fig-band-pointwise = Bande : 95 %, ponctuelle, échantillonnage seul.
report-fig-no-band = Pas de bande sous { $least } véhicules.
report-fig-by-rules = Traits verticaux : { $rules }.
report-fig-by-left-out = { $n } groupes plus petits sont omis.
report-fig-group = { $group }, n = { $n }
report-fig-no-error = Aucun véhicule n’a de hauteur de référence.
report-fig-no-errors = Il n’y a pas d’erreur à tracer.
report-fig-absolute-axis = Erreur absolue ({ $unit })
report-fig-absolute = Erreur absolue, répartition
report-fig-absolute-caption = Part cumulée des véhicules selon l’erreur absolue.
report-fig-relative-axis = Erreur absolue sur hauteur de référence (%)
report-fig-relative = Erreur relative, répartition
report-fig-relative-caption = Erreur absolue rapportée à la hauteur de référence.
report-fig-signed = Erreur signée, densité
report-fig-signed-axis = Mesure moins référence ({ $unit })
report-fig-signed-width = { $width } { $group }
report-fig-signed-caption = Noyau gaussien, largeur de bande { $widths }.
report-fig-signed-caption-cm = Noyau gaussien, largeur de bande { $widths }, au moins la moitié de l’arrondi de { $rounding }.
report-fig-trend = Erreur signée selon la hauteur du constructeur
report-fig-regression = régression
report-fig-maker-height = Hauteur du constructeur ({ $unit })
report-fig-one-mark = Une marque par véhicule. { $reason }
report-fig-per = { $small } par { $height }
report-fig-seen = Une marque par véhicule
report-fig-seen-some = Une marque pour { $shown } véhicules sur { $n }
report-fig-trend-caption = { $seen } ; régression et sa bande à 95 % : pente { $slope } ({ $interval }), r = { $r }.
report-fig-trend-caption-absolute = { $seen } ; régression et sa bande à 95 % : pente { $slope } ({ $interval }), r = { $r } ; erreur absolue : r = { $r_absolute }.
report-fig-lateral = Position latérale par voie et par classe
report-fig-lateral-axis = Distance à la caméra en travers de la route ({ $unit })
report-fig-lateral-caption = Contact du pneu, un par véhicule, selon son sens sur l’image et sa classe (nombre de véhicules) : médiane (anneau), 15e au 85e centile (épais), 5e au 95e (fin) ; chaque véhicule (trait) s’ils sont trop peu nombreux.
report-fig-crest = K d’un angle saillant selon la vitesse de référence
report-fig-by-standard = d’après les hauteurs de la norme
report-fig-by-survey = d’après les hauteurs du relevé
report-fig-design-speed = Vitesse de référence ({ $unit })
report-fig-k = K ({ $unit } par %)
report-fig-crest-caption = K = S²/C à la distance de visibilité d’arrêt de chaque vitesse, arrondie par excès comme dans les tables de conception. Plein : d’après les hauteurs du relevé, avec sa bande à 95 % ; tireté : d’après celles de la norme.
report-fig-scanned = Véhicules balayés : { $quantity }, répartition
report-fig-scanned-caption = n = { $n } ; { $percentiles } ; intervalles à 95 % là où n le permet.
report-fig-true = Hauteurs vraies, répartition : { $target }
report-fig-error-left-in = erreur aléatoire comprise
report-fig-true-curve = hauteurs vraies
report-fig-true-caption = Plein : hauteurs vraies, pondérées selon le parc quand il a été donné ; la bande relie les intervalles totaux à 95 % des centiles. Tireté : erreur aléatoire comprise.

## Rapport d’une étude

report-study-kind = Rapport d’étude
report-study-kind-simulated = Simulé : rapport d’étude
report-of-study = { $study }, rapport d’étude
report-study-simulated = <strong>Simulé.</strong> Rien n’a été filmé : les véhicules ont été tirés de parcs connus. Aucune valeur de ce rapport ne décrit de routes réelles.
report-joined = Réunis
report-joined-of = { $surveys ->
    [one] { NUMBER($surveys) } relevé
   *[other] { NUMBER($surveys) } relevés
 } sur { $sites ->
    [one] { NUMBER($sites) } site
   *[other] { NUMBER($sites) } sites
 } : { NUMBER($heights) } hauteurs validées de { $vehicles ->
    [one] { NUMBER($vehicles) } véhicule
   *[other] { NUMBER($vehicles) } véhicules
 }
report-weighted = Pondérés
report-not-weighted = non : les véhicules comptent comme ils ont été tirés
report-fleet-by = selon les parts du parc ({ $margins }), d’après son tableau
report-target-reason = { $target } : { $reason }.
report-study-table = Hauteurs au-dessus de la route en { $unit } : hauteurs vraies, pondérées selon le parc quand il a été donné, avec des intervalles totaux à 95 %.
report-sites-of = { NUMBER($n) } sites
report-study-note = Les intervalles comprennent l’échantillonnage des véhicules et des sites et les erreurs communes aux hauteurs (pose de la caméra, retrait moyen). L’erreur de mesure aléatoire est retirée des valeurs.
report-study-note-one-site = Les intervalles comprennent l’échantillonnage des véhicules et des sites et les erreurs communes aux hauteurs (pose de la caméra, retrait moyen). L’erreur de mesure aléatoire est retirée des valeurs. Avec un seul site, ils ne valent que pour celui-ci.
report-years-table = Comparaison des années : la plus récente moins la première, chacune pondérée séparément, avec des intervalles totaux à 95 %.
report-years = Années
report-year-figure = { $target }, { $figure }
report-figure-mean = moyenne
report-heights-column = Hauteurs
report-more-higher = plus haut (significatif)
report-more-lower = plus bas (significatif)
report-not-told-apart = pas de différence significative
report-year-no-interval = pas d’intervalle
report-verdict-why = { $verdict } ({ $reason })
report-makers-words = Par rapport aux hauteurs des constructeurs, { NUMBER($n) } toits ont une erreur absolue moyenne de { $mae } (95 % : { $mae_interval }) et un biais de { $bias } (95 % : { $bias_interval }).
report-studied = Données
report-surveys = Les relevés. « Comptées » : hauteurs validées qui comptent selon la règle d’échantillonnage du relevé ; « exclues » : celles de véhicules hors échantillon qui ne comptent pas.
report-survey-column = Relevé
report-site = Site
report-stratum = Strate
report-year = Année
report-counts = Comptées
report-not = Exclues
report-true-distributions = Distributions des hauteurs vraies
report-no-distribution = Aucune distribution ne peut être tracée.
report-true-percentiles = Centiles des hauteurs vraies : { $target }, avec des intervalles totaux à 95 %. Effet de plan : variance selon ce plan, rapportée à celle d’un échantillon aléatoire simple de même taille.
report-error-left-in = Erreur aléatoire comprise
report-design-effect = Effet de plan
report-effective-n = n effectif
report-makers-errors = Erreur par rapport aux hauteurs du constructeur
report-makers-table = Erreur = mesure moins hauteur du constructeur, pour les toits, sans arrondi, avec des intervalles à 95 %.
report-vehicle-classes = Classes de véhicules
report-classes-table = Parts des classes telles que tirées, en %, avec des intervalles à 95 %, comparées à celles du parc.
report-class = Classe
report-fleet = Parc
report-further = Planification d’une nouvelle étude
report-further-table = Sites, et véhicules par site, avec lesquels le P10 des hauteurs vraies aurait une U95 de { $goal }, si les sites et les véhicules varient comme ici.
report-sites = Sites
report-no-number = aucun nombre
report-study-check = L’archive de l’étude, dont le SHA-256 est ci-dessous, contient chaque valeur. { $command } donne les mêmes valeurs à partir des archives exportées des mêmes relevés ; chaque archive est d’abord contrôlée en entier, jusqu’aux pointés.
report-study = ÉTUDE
report-heads = Dernière empreinte de la chaîne d’audit de chaque relevé au moment de sa lecture.
report-last-hash = Dernière empreinte
